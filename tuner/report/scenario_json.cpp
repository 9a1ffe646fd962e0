#include "tuner/report/scenario_json.hpp"

#include <cmath>

#include "core/control/state_machine.hpp"
#include "tuner/report/base64.hpp"
#include "tuner/report/json_array.hpp"

namespace armtune::report {
namespace {

void write_series(Json& json, const Series& series) {
  json.begin_object();
  json.number("lo", series.lo);
  json.number("hi", series.hi);
  json.text("u16", base64_u16(series.steps));
  json.end_object();
}

/// [from, to]
void write_stretch(Json& json, const std::pair<double, double>& stretch) {
  json.numbers({stretch.first, stretch.second});
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
  array(json, "slerps", run.slerps, write_stretch);
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

void write_limit(Json& json, const PlanLimit& limit) {
  json.begin_object();
  json.text("limit", limit.limit);
  json.text("part", limit.part);
  json.text("words", limit.words);
  json.text("unit", limit.unit);
  json.number("lower", limit.lower);
  json.number("upper", limit.upper);
  json.number("from", limit.from);
  json.number("to", limit.to);
  json.number("at_knots", limit.at_knots);
  json.number("between_knots", limit.between_knots);
  json.number("active", limit.active);
  json.number("strength", limit.strength);
  array(json, "active_lower", limit.active_lower, write_stretch);
  array(json, "active_upper", limit.active_upper, write_stretch);
  json.text("group", limit.group);
  json.text("column", limit.column);
  json.end_object();
}

}  // namespace

void write_scenario(Json& json, const ReportScenario& scenario) {
  json.begin_object();
  json.text("name", scenario.name);
  json.number("duration", scenario.duration);
  // To a hundredth of a millimetre: it is drawn, no more.
  const auto drawn = [](double length) { return std::round(1e5 * length) / 1e5; };
  array(json, "path", scenario.path, [&drawn](Json& out, const Vec3& p) {
    out.numbers({drawn(p.x()), drawn(p.y()), drawn(p.z())});
  });
  json.number("influence_radius", scenario.influence_radius);
  json.key("obstacles");
  json.begin_array();
  for (const double radius : scenario.obstacles) {
    json.begin_object();
    json.number("body_radius", radius);
    json.end_object();
  }
  json.end_array();
  json.texts("states", {name(ControlState::kLeaveSingularity), name(ControlState::kReturnToTrajectory),
                        name(ControlState::kFollowTrajectory), name(ControlState::kAvoidObstacles),
                        name(ControlState::kFollowPlan)});
  json.integer("robot", scenario.arm);
  array(json, "runs", scenario.runs, write_run);
  array_if_any(json, "limits", scenario.limits, write_limit);
  json.end_object();
}

}  // namespace armtune::report
