#pragma once
// The data about a search on a report page: the evaluations, the gains, their sensitivities, the stability
// margins, the trade-off between criteria, and the results on random arms.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/metrics/metric.hpp"
#include "tuner/record/declaration.hpp"

namespace armtune::internal::report {

using enum record::Presence;

struct PhaseRun {
  std::size_t phase = 0, from = 0, to = 0;

  static void declare(auto& f, auto& run) {
    f.type("PhaseStretch", "Consecutive evaluations of one phase of the search, such as the sweep.");
    f("phase", run.phase, "Index into `phase` of the evaluations.");
    f("from", run.from, "Number of its first evaluation.")("to", run.to, "Number of its last evaluation.");
  }
};

struct ThinnedEvaluations {
  std::vector<std::size_t> number;
  std::size_t total = 0, feasible = 0, native = 0, without_objective = 0;
  std::vector<PhaseRun> phase_runs;
  bool more_phase_runs = false;

  static void declare(auto& f, auto& all) {
    f.type("ThinnedEvaluations",
           "How many evaluations there are, of each kind; used if there are too many to draw all.");
    f("number", all.number, "Number of each shown evaluation.")("total", all.total)("feasible", all.feasible);
    f("native", all.native)("without_objective", all.without_objective);
    f("phase_runs", all.phase_runs, "The first 500 of these.")("more_phase_runs", all.more_phase_runs);
  }
};

struct Evaluations {
  std::vector<std::string> phases;
  std::vector<std::size_t> of;
  std::vector<double> objective, violation;
  std::vector<bool> feasible, native;
  long start = -1, chosen = -1;
  std::optional<ThinnedEvaluations> thinned;

  static void declare(auto& f, auto& all) {
    f.type("Evaluations", "Every list except the first has one item per evaluation.");
    f("phase", all.phases, "Names of the phases: start, sweep, search ...");
    f("of", all.of, "Index into `phase`.")("objective", all.objective, "", kOrNull)("feasible", all.feasible);
    f("violation", all.violation, "", kOrNull);
    f("start", all.start, "Index of the evaluation of the start gains; -1 if there is none.");
    f("chosen", all.chosen, "Index of the chosen evaluation; -1 if there is none.");
    f("native", all.native,
      "True if armtune's own engine simulated it, false for Simbody. Absent if Simbody simulated all.",
      kIfAny);
    f("thinned", all.thinned, "Absent if all evaluations are shown.", kIfAny);
  }
};

struct Gain {
  std::string name, unit;
  double lower = 0.0, upper = 0.0;
  std::string scale;
  std::vector<double> values;

  static void declare(auto& f, auto& gain) {
    f.type("Gain")("name", gain.name)("unit", gain.unit)("lower", gain.lower)("upper", gain.upper);
    f("scale", gain.scale, {"log", "linear"})("values", gain.values, "One per set.");
  }
};

struct Sensitivity {
  std::string gain;
  double importance = 0.0, local = 0.0, elasticity = 0.0, rank_correlation = 0.0;

  static void declare(auto& f, auto& one) {
    f.type("Sensitivity")("gain", one.gain);
    f("importance", one.importance,
      "How much worse (larger) the merit becomes if this gain alone returns to its start value.", kOrNull);
    f("local", one.local, "Largest relative change of the merit for a small step of the gain.", kOrNull);
    f("elasticity", one.elasticity, "", kOrNull)("rank_correlation", one.rank_correlation, "", kOrNull);
  }
};

struct MarginRow {
  std::string margin, unit, scenario;
  std::vector<double> values;
  std::vector<std::string> text, reason;

  static void declare(auto& f, auto& row) {
    f.type("Margin")("margin", row.margin)("unit", row.unit);
    f("scenario", row.scenario, "Name of a scenario, or \"all\" for the smallest margin.");
    f("values", row.values, "Per set: the last value that the loop tolerates.", kOrNull);
    f("text", row.text,
      "Per set, the value as text: \"2\"; \"≥ 100\" if nothing failed; \"none\" if the nominal value fails; "
      "empty if it was not searched.");
    f("reason", row.reason, "Per set: what fails beyond this value.");
  }
};

struct FrontPoint {
  std::vector<double> values;
  std::string label;
  bool feasible = false;
  std::string role;

  static void declare(auto& f, auto& point) {
    f.type("FrontPoint")("values", point.values);
    f("label", point.label, "The label of the start says that it is the start; other labels say no role.");
    f("feasible", point.feasible);
    f("role", point.role, {"start", "chosen", "shown", "point"},
      "chosen: the result of a search; shown: the point of a front that replay and tables show.");
  }
};

struct Criterion {
  std::string name, unit;

  static void declare(auto& f, auto& c) { f.type("Criterion")("name", c.name)("unit", c.unit); }
};

struct CriterionLimit {
  std::size_t criterion = 0;
  double value = 0.0;
  bool operator==(const CriterionLimit&) const = default;

  static void declare(auto& f, auto& limit) {
    f.type("CriterionLimit", "A limit of the study for a criterion.");
    f("criterion", limit.criterion, "Index into `criteria`.")("value", limit.value);
  }
};

struct Front {
  std::vector<Criterion> criteria;
  std::vector<FrontPoint> points;
  std::vector<CriterionLimit> limits;
  std::optional<double> hypervolume;

  static void declare(auto& f, auto& front) {
    f.type("Front")("criteria", front.criteria)("points", front.points)("limits", front.limits);
    f("hypervolume", front.hypervolume);
  }
};

struct Histogram {
  Metric metric = Metric::kPositionMax;
  std::string scenario;
  std::optional<double> limit, nominal;
  std::vector<std::size_t> counts;
  std::size_t failed = 0;
  std::vector<double> edges;

  static void declare(auto& f, auto& one) {
    f.type("Histogram")("metric", field(one.metric).name)("unit", field(one.metric).unit);
    f("scenario", one.scenario)("limit", one.limit)("counts", one.counts);
    f("failed", one.failed, "Number of arms that did not complete; they have no value.");
    f("edges", one.edges, "Edges of the bins, one more than counts.")("nominal", one.nominal);
  }
};

struct WorstSample {
  long sample = 0;
  std::string text;

  static void declare(auto& f, auto& one) { f.type("WorstSample")("sample", one.sample)("text", one.text); }
};

struct Robustness {
  std::size_t samples = 0;
  std::size_t kept = 0;  ///< number of arms that keep every limit
  std::pair<double, double> interval;
  std::vector<Histogram> histograms;
  std::vector<WorstSample> worst;
  /// Each limit that was broken, with its scenario, and the number of arms that broke it; most arms first.
  std::vector<std::pair<std::string, std::size_t>> broken;

  /// Returns the share of the arms that keep every limit, or 0 if there are no arms.
  double yield() const {
    return samples > 0 ? static_cast<double>(kept) / static_cast<double>(samples) : 0.0;
  }

  static void declare(auto& f, auto& all) {
    f.type("Robustness")("samples", all.samples);
    f("yield", all.yield(), "Share of the arms that keep every limit.");
    f("interval", all.interval, "95 % interval of the yield.")("histograms", all.histograms)("worst",
                                                                                             all.worst);
  }
};

}  // namespace armtune::internal::report
