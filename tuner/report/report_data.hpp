#pragma once
// All that a report page shows, as web/src/data.ts has it. NaN stands for a value that there is not.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/metrics/metric.hpp"
#include "tuner/report/arm.hpp"
#include "tuner/report/run_kind.hpp"
#include "tuner/report/series.hpp"
#include "tuner/report/yardstick_rows.hpp"

namespace armtune::report {

/// One metric of a scenario.
struct MetricRow {
  Metric metric = Metric::kPositionMax;
  std::vector<double> values;     ///< one per set
  std::vector<std::string> text;  ///< the same, or empty
};

struct Table {
  std::string scenario;
  std::vector<MetricRow> rows;
  std::vector<std::string> status;  ///< one per set, empty where there is none
  std::vector<std::string> reason;  ///< one per set, of what did not complete
};

/// What a study on many arms was judged by.
struct Judged {
  std::string measure;  ///< "worst of 5 arms each"
  std::vector<Table> tables;
};

struct PlotColumn {
  std::string name;
  std::string group;
  std::string unit;
  Series series;
};

struct Replay {
  double dt = 0.0;  ///< [s]
  std::size_t n = 0;
  std::vector<Series> q;
  std::vector<Series> target;
  std::vector<std::vector<Series>> obstacles;
  std::vector<Series> tool;
  Series error;
  std::vector<Series> velocity_ratio;
};

struct StateChange {
  double time = 0.0;  ///< [s]
  int state = 0;
};

struct Run {
  std::size_t set = 0;
  std::string status;
  std::string reason;  ///< when, where and why it ended, of what did not complete
  double start = 0.0;  ///< what the scenario's clock began with [s]; all times below are since then
  double end = 0.0;    ///< [s]
  std::vector<StateChange> states;
  std::vector<std::pair<double, double>> slerps;  ///< begin and end [s]
  double shortest_state = 0.0;  ///< states and slerps that are shorter [s] are left out; 0: all are there
  Series time;
  std::vector<PlotColumn> columns;
  Replay replay;
};

/// A limit of one joint or axis that a plan keeps; times from the plan's start [s].
struct PlanLimit {
  std::string limit;
  std::string part;
  std::string words;  ///< both
  std::string unit;
  double lower = 0.0;  ///< in `unit`
  double upper = 0.0;
  double from = 0.0;  ///< when it holds
  double to = 0.0;
  double at_knots = 0.0;  ///< largest share that is used
  double between_knots = 0.0;
  double active = 0.0;  ///< share of the knots at which it holds the plan back
  double strength = 0.0;
  std::vector<std::pair<double, double>> active_lower;
  std::vector<std::pair<double, double>> active_upper;
  std::string group;  ///< of the plot that it is drawn in
  std::string column;
};

struct ReportScenario {
  std::string name;
  double duration = 0.0;
  std::vector<Vec3> path;
  double influence_radius = 0.0;
  std::vector<double> obstacles;  ///< radius of each one's body [m]
  long arm = -1;                  ///< index into ReportData::arms; -1: not known
  std::vector<Run> runs;
  std::vector<PlanLimit> limits;  ///< of a plan alone
};

/// Consecutive evaluations of one phase.
struct PhaseRun {
  std::size_t phase = 0;  ///< index into Evaluations::phases
  std::size_t from = 0;   ///< number of its first evaluation
  std::size_t to = 0;     ///< and of its last one
};

/// What evaluations are counted by where a page shows some of them only.
struct ThinnedEvaluations {
  std::vector<std::size_t> number;  ///< of each one that is shown
  std::size_t total = 0;
  std::size_t feasible = 0;
  std::size_t native = 0;
  std::size_t without_objective = 0;
  std::vector<PhaseRun> phase_runs;  ///< the first 500
  bool more_phase_runs = false;
};

struct Evaluations {
  std::vector<std::string> phases;
  std::vector<std::size_t> of;  ///< per evaluation: index into `phases`
  std::vector<double> objective;
  std::vector<bool> feasible;
  std::vector<double> violation;
  std::vector<bool> native;  ///< of armtune's own engine; empty where none is
  long start = -1;           ///< index into the arrays above
  long chosen = -1;
  std::optional<ThinnedEvaluations> thinned;  ///< none: all are shown
};

struct Gain {
  std::string name;
  std::string unit;
  double lower = 0.0;
  double upper = 0.0;
  std::string scale;
  std::vector<double> values;  ///< one per set
};

struct Sensitivity {
  std::string gain;
  double importance = 0.0;
  double local = 0.0;
  double elasticity = 0.0;
  double rank_correlation = 0.0;
};

struct MarginRow {
  std::string margin;
  std::string unit;
  std::string scenario;
  std::vector<double> values;     ///< one per set
  std::vector<std::string> text;  ///< one per set, the value in words
  std::vector<std::string> reason;
};

struct FrontPoint {
  std::vector<double> values;
  std::string label;
  bool feasible = false;
  std::string role;  ///< start, chosen, shown, point
};

struct Front {
  std::vector<std::pair<std::string, std::string>> criteria;  ///< name, unit
  std::vector<FrontPoint> points;
  std::vector<std::pair<std::size_t, double>> limits;  ///< index of a criterion, what the study allows of it
  std::optional<double> hypervolume;
};

struct Histogram {
  Metric metric = Metric::kPositionMax;
  std::string scenario;
  std::optional<double> limit;
  std::vector<std::size_t> counts;
  std::size_t failed = 0;  ///< arms that did not complete, of which there is no value
  std::vector<double> edges;
  std::optional<double> nominal;
};

struct WorstSample {
  long sample = 0;
  std::string text;
};

struct Robustness {
  std::size_t samples = 0;
  std::size_t kept = 0;  ///< keep every limit
  std::pair<double, double> interval;
  std::vector<Histogram> histograms;
  std::vector<WorstSample> worst;
  std::vector<std::pair<std::string, std::size_t>> broken;  ///< limit and samples that break it, most first
};

/// Beside its limits.
struct Plan {
  double start = 0.0;  ///< on its scenario's time [s]
  std::string scenario;
  std::vector<std::pair<std::string, std::string>> figures;  ///< name, value
};

struct Verdict {
  std::string sentence;
  std::vector<std::string> details;
};

/// Of a page that is written again and again while its run goes on.
struct Live {
  long evaluations = 0;
  long most_evaluations = 0;
  double seconds_left = 0.0;  ///< about, of the search
  double every = 0.0;         ///< [s] the page loads itself again
  long written = 0;           ///< when, seconds since 1970
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
  std::string command;
  std::vector<std::pair<std::string, std::string>> provenance;
  std::vector<std::string> left_out;  ///< why, of files that could not be understood
  std::vector<std::string> thinned;   ///< what the page does not show so that it does not become too large
};

/// The object that web/src/data.ts calls ReportData. It may stand inside an HTML page: no `<` is in it.
std::string report_json(const ReportData& data);

/// What a scenario adds to that: the object that web/src/data.ts calls Scenario.
std::string scenario_json(const ReportScenario& scenario);

}  // namespace armtune::report
