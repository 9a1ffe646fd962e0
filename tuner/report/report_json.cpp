#include "core/control/state_machine.hpp"
#include "tuner/report/arm_json.hpp"
#include "tuner/report/base64.hpp"
#include "tuner/report/json.hpp"
#include "tuner/report/report_data.hpp"

namespace armtune::report {
namespace {

/// key: [each of items, as `write` writes it].
template <typename Items, typename Write>
void array(Json& json, const char* key, const Items& items, Write write) {
  json.key(key);
  json.begin_array();
  for (const auto& item : items) write(json, item);
  json.end_array();
}

void write_series(Json& json, const Series& series) {
  json.begin_object();
  json.number("lo", series.lo);
  json.number("hi", series.hi);
  json.text("u16", base64_u16(series.steps));
  json.end_object();
}

void write_optional(Json& json, const char* key, const std::optional<double>& value) {
  json.key(key);
  value ? json.number(*value) : json.null();
}

void write_row(Json& json, const MetricRow& row) {
  const MetricField& f = field(row.metric);
  json.begin_object();
  json.text("metric", f.name);
  json.text("unit", f.unit);
  json.text("words", f.words);
  json.text("meaning", f.meaning);
  json.numbers("values", row.values);
  if (!row.text.empty()) json.texts("text", row.text);
  json.text("better", larger_is_better(row.metric) ? "higher" : "lower");
  json.end_object();
}

void write_table(Json& json, const Table& table) {
  json.begin_object();
  json.text("scenario", table.scenario);
  array(json, "rows", table.rows, write_row);
  json.texts("status", table.status);
  json.texts("reason", table.reason);
  json.end_object();
}

void write_replay(Json& json, const Replay& replay) {
  json.begin_object();
  json.number("dt", replay.dt);
  json.integer("n", static_cast<long>(replay.n));
  array(json, "q", replay.q, write_series);
  array(json, "target", replay.target, write_series);
  array(json, "obstacles", replay.obstacles, [](Json& out, const std::vector<Series>& center) {
    out.begin_array();
    for (const Series& axis : center) write_series(out, axis);
    out.end_array();
  });
  array(json, "tool", replay.tool, write_series);
  json.key("error");
  write_series(json, replay.error);
  array(json, "velocity_ratio", replay.velocity_ratio, write_series);
  json.end_object();
}

void write_run(Json& json, const Run& run) {
  json.begin_object();
  json.integer("set", static_cast<long>(run.set));
  json.text("status", run.status);
  json.text("reason", run.reason);
  json.number("start", run.start);
  json.number("end", run.end);
  array(json, "states", run.states, [](Json& out, const StateChange& change) {
    out.begin_object();
    out.number("t", change.time);
    out.integer("state", change.state);
    out.end_object();
  });
  array(json, "slerps", run.slerps, [](Json& out, const std::pair<double, double>& slerp) {
    out.begin_array();
    out.number(slerp.first);
    out.number(slerp.second);
    out.end_array();
  });
  json.key("time");
  write_series(json, run.time);
  array(json, "columns", run.columns, [](Json& out, const PlotColumn& column) {
    out.begin_object();
    out.text("name", column.name);
    out.text("group", column.group);
    out.text("unit", column.unit);
    out.key("series");
    write_series(out, column.series);
    out.end_object();
  });
  json.key("replay");
  write_replay(json, run.replay);
  json.end_object();
}

void write_scenario(Json& json, const ReportScenario& scenario) {
  json.begin_object();
  json.text("name", scenario.name);
  json.number("duration", scenario.duration);
  array(json, "path", scenario.path, [](Json& out, const Vec3& p) {
    out.begin_array();
    for (int axis = 0; axis < 3; ++axis) out.number(p[axis]);
    out.end_array();
  });
  json.number("influence_radius", scenario.influence_radius);
  json.key("obstacles");
  json.begin_array();
  for (std::size_t i = 0; i < scenario.obstacles; ++i) {
    json.begin_object();
    json.key("body_radius");
    json.null();  // no scenario has one yet
    json.end_object();
  }
  json.end_array();
  json.texts("states", {name(ControlState::kLeaveSingularity), name(ControlState::kReturnToTrajectory),
                        name(ControlState::kFollowTrajectory), name(ControlState::kAvoidObstacles),
                        name(ControlState::kFollowPlan)});
  json.integer("robot", scenario.arm);
  array(json, "runs", scenario.runs, write_run);
  json.end_object();
}

void write_evaluations(Json& json, const Evaluations& e) {
  json.begin_object();
  json.texts("phase", e.phases);
  array(json, "of", e.of, [](Json& out, std::size_t phase) { out.integer(static_cast<long>(phase)); });
  json.numbers("objective", e.objective);
  array(json, "feasible", e.feasible, [](Json& out, bool feasible) { out.boolean(feasible); });
  json.numbers("violation", e.violation);
  if (!e.native.empty()) {
    array(json, "native", e.native, [](Json& out, bool native) { out.boolean(native); });
  }
  json.integer("start", e.start);
  json.integer("chosen", e.chosen);
  json.end_object();
}

void write_gain(Json& json, const Gain& gain) {
  json.begin_object();
  json.text("name", gain.name);
  json.text("unit", gain.unit);
  json.number("lower", gain.lower);
  json.number("upper", gain.upper);
  json.text("scale", gain.scale);
  json.numbers("values", gain.values);
  json.end_object();
}

void write_sensitivity(Json& json, const Sensitivity& s) {
  json.begin_object();
  json.text("gain", s.gain);
  json.number("importance", s.importance);
  json.number("local", s.local);
  json.number("elasticity", s.elasticity);
  json.number("rank_correlation", s.rank_correlation);
  json.end_object();
}

void write_margin(Json& json, const MarginRow& row) {
  json.begin_object();
  json.text("margin", row.margin);
  json.text("unit", row.unit);
  json.text("scenario", row.scenario);
  json.numbers("values", row.values);
  json.texts("text", row.text);
  json.texts("reason", row.reason);
  json.end_object();
}

void write_front(Json& json, const Front& front) {
  json.begin_object();
  array(json, "criteria", front.criteria,
        [](Json& out, const std::pair<std::string, std::string>& criterion) {
          out.begin_object();
          out.text("name", criterion.first);
          out.text("unit", criterion.second);
          out.end_object();
        });
  array(json, "points", front.points, [](Json& out, const FrontPoint& point) {
    out.begin_object();
    out.numbers("values", point.values);
    out.text("label", point.label);
    out.boolean("feasible", point.feasible);
    out.text("role", point.role);
    out.end_object();
  });
  array(json, "limits", front.limits, [](Json& out, const std::pair<std::size_t, double>& limit) {
    out.begin_object();
    out.integer("criterion", static_cast<long>(limit.first));
    out.number("value", limit.second);
    out.end_object();
  });
  write_optional(json, "hypervolume", front.hypervolume);
  json.end_object();
}

void write_histogram(Json& json, const Histogram& histogram) {
  json.begin_object();
  json.text("metric", field(histogram.metric).name);
  json.text("unit", field(histogram.metric).unit);
  json.text("scenario", histogram.scenario);
  write_optional(json, "limit", histogram.limit);
  array(json, "counts", histogram.counts,
        [](Json& out, std::size_t count) { out.integer(static_cast<long>(count)); });
  json.integer("failed", static_cast<long>(histogram.failed));
  json.numbers("edges", histogram.edges);
  write_optional(json, "nominal", histogram.nominal);
  json.end_object();
}

void write_robustness(Json& json, const Robustness& r) {
  json.begin_object();
  json.integer("samples", static_cast<long>(r.samples));
  json.number("yield", r.samples > 0 ? static_cast<double>(r.kept) / static_cast<double>(r.samples) : 0.0);
  json.numbers("interval", {r.interval.first, r.interval.second});
  array(json, "histograms", r.histograms, write_histogram);
  array(json, "worst", r.worst, [](Json& out, const WorstSample& worst) {
    out.begin_object();
    out.integer("sample", worst.sample);
    out.text("text", worst.text);
    out.end_object();
  });
  json.end_object();
}

}  // namespace

std::string report_json(const ReportData& data) {
  Json json;
  json.begin_object();
  json.integer("format", 1);
  json.text("kind", name(data.kind));
  json.text("title", data.title);
  json.key("verdict");
  json.begin_object();
  json.text("sentence", data.verdict.sentence);
  json.texts("details", data.verdict.details);
  json.end_object();
  json.texts("sets", data.sets);
  array(json, "tables", data.tables, write_table);
  if (data.judged) {
    json.key("judged");
    json.begin_object();
    json.text("measure", data.judged->measure);
    array(json, "tables", data.judged->tables, write_table);
    json.end_object();
  }
  array(json, "robots", data.arms, write_arm);
  array(json, "scenarios", data.scenarios, write_scenario);
  if (data.evaluations) {
    json.key("evaluations");
    write_evaluations(json, *data.evaluations);
  }
  if (!data.gains.empty()) array(json, "gains", data.gains, write_gain);
  if (!data.sensitivity.empty()) array(json, "sensitivity", data.sensitivity, write_sensitivity);
  if (!data.margins.empty()) array(json, "margins", data.margins, write_margin);
  if (data.front) {
    json.key("front");
    write_front(json, *data.front);
  }
  if (data.robustness) {
    json.key("robustness");
    write_robustness(json, *data.robustness);
  }
  json.key("provenance");
  json.begin_object();
  json.text("command", data.command);
  array(json, "entries", data.provenance, [](Json& out, const std::pair<std::string, std::string>& entry) {
    out.begin_array();
    out.text(entry.first);
    out.text(entry.second);
    out.end_array();
  });
  json.end_object();
  json.end_object();
  return json.take();
}

}  // namespace armtune::report
