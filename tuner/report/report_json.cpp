// The data of a page as web/src/data.ts declares it, and scene.json, written by nlohmann's JSON library. It
// writes NaN and infinity as null, and every other number so that it reads back to the same bits.

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/control/state_machine.hpp"
#include "tuner/report/base64.hpp"
#include "tuner/report/report_data.hpp"
#include "tuner/report/scene.hpp"

using Json = nlohmann::ordered_json;

namespace nlohmann {

template <typename T>
struct adl_serializer<std::optional<T>> {
  static void to_json(Json& json, const std::optional<T>& value) { value ? json = *value : json = nullptr; }
};

template <>
struct adl_serializer<armtune::Vec3> {
  static void to_json(Json& json, const armtune::Vec3& v) { json = {v.x(), v.y(), v.z()}; }
};

}  // namespace nlohmann

namespace armtune::report {

/// An object of these members, each under its own name.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage)
#define ARMTUNE_MEMBERS(Type, ...)                                           \
  static void to_json(Json& nlohmann_json_j, const Type& nlohmann_json_t) {  \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_TO, __VA_ARGS__)) \
  }

namespace {

/// Writes a list or an optional value under its key, and nothing where it is empty.
template <typename T>
void put_if_any(Json& json, const char* key, const std::vector<T>& values) {
  if (!values.empty()) json[key] = values;
}
template <typename T>
void put_if_any(Json& json, const char* key, const std::optional<T>& value) {
  if (value) json[key] = *value;
}

void put_pose(Json& json, const Pose& pose) {
  json["p"] = pose.p;
  json["q"] = {pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()};
}

/// `<` is written as `\u003c`, so that nothing in the text ends a script element or begins a comment, and DEL
/// as `\u007f`, which YAML's readers want. Bytes that are not UTF-8 become U+FFFD.
std::string text_of(const Json& json) {
  const std::string plain = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string text;
  text.reserve(plain.size());
  for (const char c : plain) {
    if (c == '<' || c == '\x7f') {
      text += c == '<' ? "\\u003c" : "\\u007f";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

static void to_json(Json& json, const MetricRow& row) {
  const MetricField& f = field(row.metric);
  json = {{"metric", f.name},
          {"unit", f.unit},
          {"words", f.words},
          {"meaning", f.meaning},
          {"values", row.values}};
  put_if_any(json, "text", row.text);
  if (f.better != Better::kNeither) json["better"] = f.better == Better::kMore ? "higher" : "lower";
}

ARMTUNE_MEMBERS(Table, scenario, rows, status, reason)
ARMTUNE_MEMBERS(Judged, measure, tables)

static void to_json(Json& json, const PhaseRun& run) {
  json = {run.phase, run.from, run.to};
}

ARMTUNE_MEMBERS(ThinnedEvaluations, number, total, feasible, native, without_objective, phase_runs,
                more_phase_runs)

static void to_json(Json& json, const Evaluations& e) {
  json = {
      {"phase", e.phases},        {"of", e.of},       {"objective", e.objective}, {"feasible", e.feasible},
      {"violation", e.violation}, {"start", e.start}, {"chosen", e.chosen}};
  put_if_any(json, "native", e.native);
  put_if_any(json, "thinned", e.thinned);
}

ARMTUNE_MEMBERS(Gain, name, unit, lower, upper, scale, values)
ARMTUNE_MEMBERS(Sensitivity, gain, importance, local, elasticity, rank_correlation)
ARMTUNE_MEMBERS(MarginRow, margin, unit, scenario, values, text, reason)
ARMTUNE_MEMBERS(YardstickRow, set, scenario, event, time, reached, limit, ratio, unit, held_back_by, words)
ARMTUNE_MEMBERS(FrontPoint, values, label, feasible, role)

static void to_json(Json& json, const Front& front) {
  json = {{"criteria", Json::array()},
          {"points", front.points},
          {"limits", Json::array()},
          {"hypervolume", front.hypervolume}};
  for (const auto& [name, unit] : front.criteria)
    json["criteria"].push_back({{"name", name}, {"unit", unit}});
  for (const auto& [criterion, value] : front.limits)
    json["limits"].push_back({{"criterion", criterion}, {"value", value}});
}

static void to_json(Json& json, const Histogram& histogram) {
  const MetricField& f = field(histogram.metric);
  json = {{"metric", f.name},
          {"unit", f.unit},
          {"scenario", histogram.scenario},
          {"limit", histogram.limit},
          {"counts", histogram.counts},
          {"failed", histogram.failed},
          {"edges", histogram.edges},
          {"nominal", histogram.nominal}};
}

ARMTUNE_MEMBERS(WorstSample, sample, text)

static void to_json(Json& json, const Robustness& r) {
  json = {{"samples", r.samples},
          {"yield", r.samples > 0 ? static_cast<double>(r.kept) / static_cast<double>(r.samples) : 0.0},
          {"interval", r.interval},
          {"histograms", r.histograms},
          {"worst", r.worst}};
}

ARMTUNE_MEMBERS(Live, evaluations, most_evaluations, seconds_left, every, written)
ARMTUNE_MEMBERS(Plan, start, scenario, figures)
ARMTUNE_MEMBERS(Verdict, sentence, details)

static void to_json(Json& json, const Series& series) {
  json = {{"lo", series.lo}, {"hi", series.hi}, {"u16", base64_u16(series.steps)}};
}

ARMTUNE_MEMBERS(Replay, dt, n, q, target, obstacles, tool, error, velocity_ratio)
ARMTUNE_MEMBERS(PlotColumn, name, group, unit, series)

static void to_json(Json& json, const StateChange& change) {
  json = {{"t", change.time}, {"state", change.state}};
}

ARMTUNE_MEMBERS(Run, set, status, reason, start, end, states, slerps, time, columns, replay)
ARMTUNE_MEMBERS(PlanLimit, limit, part, words, unit, lower, upper, from, to, at_knots, between_knots, active,
                strength, active_lower, active_upper, group, column)

static void to_json(Json& json, const ReportScenario& scenario) {
  json = {{"name", scenario.name},
          {"duration", scenario.duration},
          {"path", Json::array()},
          {"influence_radius", scenario.influence_radius},
          {"obstacles", Json::array()},
          {"states",
           {name(ControlState::kLeaveSingularity), name(ControlState::kReturnToTrajectory),
            name(ControlState::kFollowTrajectory), name(ControlState::kAvoidObstacles),
            name(ControlState::kFollowPlan)}},
          {"robot", scenario.arm},
          {"runs", scenario.runs}};
  // To a hundredth of a millimetre: it is drawn, no more.
  for (const Vec3& p : scenario.path) json["path"].push_back(Vec3((1e5 * p).array().round() / 1e5));
  for (const double radius : scenario.obstacles) json["obstacles"].push_back({{"body_radius", radius}});
  put_if_any(json, "limits", scenario.limits);
}

static void to_json(Json& json, const ArmJoint& joint) {
  json = {{"name", joint.name}, {"kind", joint.prismatic ? "prismatic" : "revolute"}};
  put_pose(json, joint.pose);
  json["velocity_limit"] = joint.velocity_limit;
  json["effort_limit"] = joint.effort_limit;
  json["lower"] = joint.lower;
  json["upper"] = joint.upper;
}

static void to_json(Json& json, const ArmShape& shape) {
  json = {{"joint", shape.joint}, {"kind", shape.kind}, {"size", shape.size}};
  put_pose(json, shape.pose);
  if (!shape.triangles.empty()) json["triangles"] = shape.triangles;
}

static void to_json(Json& json, const Arm& arm) {
  json = {{"name", arm.name}, {"joints", arm.joints}, {"shapes", arm.shapes}, {"undrawn", arm.undrawn}};
  put_pose(json["tool"], arm.tool);
}

ARMTUNE_MEMBERS(SceneSet, name, folder, errors)

static Json path_json(const Path& path) {
  Json json = {{"center", path.center},
               {"frequency", path.frequency},
               {"phase", path.phase},
               {"terms", Json::array()}};
  for (const HarmonicTerm& term : path.terms)
    json["terms"].push_back({{"order", term.order}, {"cosine", term.cosine}, {"sine", term.sine}});
  if (!path.spline) return json;
  Json& rows = json["knots"] = Json::array();
  for (std::size_t k = 0; k < path.spline->time().size(); ++k) {
    const MotionPoint<Vec3>& knot = path.spline->knots()[k];
    Json row = Json::array({path.spline->time()[k]});
    for (const Vec3* v : {&knot.position, &knot.velocity, &knot.acceleration})
      for (const double value : *v) row.push_back(value);
    rows.push_back(std::move(row));
  }
  json["loops"] = path.spline->loops();
  return json;
}

static void to_json(Json& json, const SceneObstacle& obstacle) {
  json = {{"radius", obstacle.radius}, {"path", path_json(obstacle.path)}};
}

static void to_json(Json& json, const SceneScenario& s) {
  json = {{"name", s.name},           {"duration", s.duration},
          {"robot", s.arm},           {"path", path_json(s.path)},
          {"obstacles", s.obstacles}, {"influence_radius", s.influence_radius}};
}

std::string scene_json(const Scene& scene) {
  return text_of({{"sets", scene.sets}, {"scenarios", scene.scenarios}, {"robots", scene.arms}}) + '\n';
}

std::string scenario_json(const ReportScenario& scenario) {
  return text_of(scenario);
}

std::string report_json(const ReportData& data) {
  Json json = {{"format", 1},
               {"kind", name(data.kind)},
               {"title", data.title},
               {"verdict", data.verdict},
               {"sets", data.sets},
               {"tables", data.tables},
               {"robots", data.arms},
               {"scenarios", data.scenarios},
               {"provenance", {{"command", data.command}, {"entries", data.provenance}}}};
  put_if_any(json, "live", data.live);
  put_if_any(json, "judged", data.judged);
  put_if_any(json, "evaluations", data.evaluations);
  put_if_any(json, "gains", data.gains);
  put_if_any(json, "sensitivity", data.sensitivity);
  put_if_any(json, "margins", data.margins);
  put_if_any(json, "yardstick", data.yardstick);
  put_if_any(json, "front", data.front);
  put_if_any(json, "robustness", data.robustness);
  put_if_any(json, "plan", data.plan);
  return text_of(json);
}

}  // namespace armtune::report
