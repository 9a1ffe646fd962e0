#pragma once
// The data that a report page shows. Each member is declared once with its meaning. The JSON in the page and
// the types of web/src/data.ts are made from the declarations. Units are SI. NaN stands for a missing value.
// Texts are shown literally: HTML in a name is not interpreted. A section without data is not shown.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/metrics/metric.hpp"
#include "tuner/record/declaration.hpp"
#include "tuner/report/arm.hpp"
#include "tuner/report/calibration_data.hpp"
#include "tuner/report/scenario_data.hpp"
#include "tuner/report/search_data.hpp"
#include "tuner/report/validation_data.hpp"
#include "tuner/report/yardstick_rows.hpp"
#include "tuner/run/run_kind.hpp"

namespace armtune::internal::report {

/// The joint that a value of a metric belongs to, and the time of the value as a text, such as " at 6.01 s".
/// Each of the two may be empty.
struct Place {
  std::string joint, when;
};

struct MetricRow {
  Metric metric = Metric::kPositionMax;
  std::vector<double> values;
  std::vector<std::string> text;
  std::vector<Place> places;  ///< joint and time of each set's value, or empty

  static void declare(auto& f, auto& row) {
    const MetricField& metric = field(row.metric);
    const auto better = {"lower", "higher", ""};
    f.type("MetricRow", "One metric of a scenario.")("metric", metric.name)("unit", metric.unit);
    f("words", metric.words, "Name in a sentence: \"largest position error\".")("meaning", metric.meaning);
    f("values", row.values, "One per set; null if there is none.", kOrNull);
    f("text", row.text, "One per set: a note on the value, such as the joint and the time of a ratio.",
      kIfAny);
    f("better", better.begin()[static_cast<int>(metric.better)], {"lower", "higher"},
      "The direction of an improvement; absent: neither direction is coloured.", kIfAny);
  }
};

struct Table {
  std::string scenario;
  std::vector<MetricRow> rows;
  std::vector<std::string> status, reason;

  static void declare(auto& f, auto& table) {
    f.type("Table", "Numbers of one scenario, one value per set.")("scenario", table.scenario)("rows",
                                                                                               table.rows);
    f("status", table.status, "One per set: \"completed\", \"diverged\" ...; empty if there is none.");
    f("reason", table.reason, "One per set: when, where and why the rollout ended; empty if it completed.");
  }
};

struct Judged {
  std::string measure;
  std::vector<Table> tables;

  static void declare(auto& f, auto& judged) {
    f.type("Judged",
           "Tables over all arms of a study on many arms; the other tables are of the nominal arm alone.");
    f("measure", judged.measure, "The measure over the arms, such as \"worst of 5 arms in each scenario\".")(
        "tables", judged.tables);
  }
};

struct Plan {
  double start = 0.0;
  std::string scenario;
  std::vector<std::pair<std::string, std::string>> figures;

  static void declare(auto& f, auto& plan) {
    f.type("Plan", "A plan, and how well it was solved. The run's only scenario has its limits.");
    f("start", plan.start, "Time of its scenario at which it begins, s; times on the page count from it.");
    f("scenario", plan.scenario)("figures", plan.figures, "Name and value: knots, violation, residuals ...");
  }
};

struct Verdict {
  std::string sentence;
  std::vector<std::string> details;

  static void declare(auto& f, auto& v) { f.type("Verdict")("sentence", v.sentence)("details", v.details); }
};

struct Live {
  long evaluations = 0, most_evaluations = 0;
  double seconds_left = 0.0, every = 0.0;
  long written = 0;

  static void declare(auto& f, auto& live) {
    f.type("Live", "Progress of a run that rewrites its page until it ends.");
    f("evaluations", live.evaluations)("most_evaluations", live.most_evaluations);
    f("seconds_left", live.seconds_left, "Estimated time left in the search.", kOrNull);
    f("every", live.every, "Seconds after which the page reloads itself.");
    f("written", live.written, "Time at which the page was written: seconds since 1970.");
  }
};

struct Provenance {
  std::string command;
  std::vector<std::pair<std::string, std::string>> entries;

  static void declare(auto& f, auto& p) { f.type("Provenance")("command", p.command)("entries", p.entries); }
};

struct ReportData {
  RunKind kind = RunKind::kSimulate;
  std::string title;
  Verdict verdict;
  std::optional<Live> live;
  std::vector<std::string> sets;
  std::vector<Table> tables;
  std::optional<Judged> judged;
  std::vector<Arm> arms;
  std::vector<ReportScenario> scenarios;
  std::optional<Evaluations> evaluations;
  std::vector<Gain> gains;
  std::vector<Sensitivity> sensitivity;
  std::vector<MarginRow> margins;
  std::vector<YardstickRow> yardstick;
  std::optional<Front> front;
  std::optional<Robustness> robustness;
  std::optional<Plan> plan;
  std::optional<ValidationData> validation;
  std::optional<CalibrationData> calibration;
  Provenance provenance;
  std::vector<std::string> left_out;  ///< for each file that could not be understood, the reason
  std::vector<std::string> thinned;   ///< parts that the page leaves out to limit its size

  static void declare(auto& f, auto& data) {
    f.type("ReportData")("format", 1)("kind", data.kind)("title", data.title)("verdict", data.verdict);
    f("sets", data.sets, "Names of the gain sets; index 0 is the reference, the last is the result.");
    f("tables", data.tables);
    f("robots", data.arms, "Every arm of the scenarios; empty if they are unknown.");
    f("scenarios", data.scenarios)("provenance", data.provenance)("live", data.live, "", kIfAny);
    f("judged", data.judged, "", kIfAny)("evaluations", data.evaluations, "", kIfAny);
    f("gains", data.gains, "", kIfAny)("sensitivity", data.sensitivity, "", kIfAny);
    f("margins", data.margins, "", kIfAny)("yardstick", data.yardstick, "", kIfAny);
    f("front", data.front, "", kIfAny)("robustness", data.robustness, "", kIfAny)("plan", data.plan, "",
                                                                                  kIfAny);
    f("validation", data.validation, "", kIfAny)("calibration", data.calibration, "", kIfAny);
  }
};

/// Returns the data as JSON text of the type ReportData in web/src/data.ts. The text contains no `<`, so that
/// it can be inserted into an HTML page.
std::string report_json(const ReportData& data);

}  // namespace armtune::internal::report
