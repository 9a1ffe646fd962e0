#include "tuner/report/scene.hpp"

#include "sim/csv/csv_table.hpp"
#include "tuner/report/arm_json.hpp"
#include "tuner/report/json.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::report {
namespace {

void write_path(Json& json, const Path& path) {
  json.begin_object();
  json.numbers("center", {path.center.x(), path.center.y(), path.center.z()});
  json.number("frequency", path.frequency);
  json.number("phase", path.phase);
  json.key("terms");
  json.begin_array();
  for (const HarmonicTerm& term : path.terms) {
    json.begin_object();
    json.integer("order", term.order);
    json.numbers("cosine", {term.cosine.x(), term.cosine.y(), term.cosine.z()});
    json.numbers("sine", {term.sine.x(), term.sine.y(), term.sine.z()});
    json.end_object();
  }
  json.end_array();
  if (path.spline) {
    json.key("knots");
    json.begin_array();
    for (std::size_t k = 0; k < path.spline->time().size(); ++k) {
      const MotionPoint<Vec3>& knot = path.spline->knots()[k];
      std::vector<double> row = {path.spline->time()[k]};
      for (const Vec3* v : {&knot.position, &knot.velocity, &knot.acceleration})
        row.insert(row.end(), v->begin(), v->end());
      json.numbers(row);
    }
    json.end_array();
    json.boolean("loops", path.spline->loops());
  }
  json.end_object();
}

void write_obstacle(Json& json, const SceneObstacle& obstacle) {
  json.begin_object();
  json.number("radius", obstacle.radius);
  json.key("path");
  write_path(json, obstacle.path);
  json.end_object();
}

}  // namespace

std::vector<SceneSet> usual_sets(RunKind kind, const std::string& folder) {
  switch (kind) {
    case RunKind::kTune:
      return {{"start", "start", "start/errors.csv"}, {"tuned", ".", "errors.csv"}};
    case RunKind::kPareto:
      return {{"start", "start", "start/errors.csv"}};
    case RunKind::kSimulate:
      return {{"gains", ".", "errors.csv"}};
    case RunKind::kRobustness:
      return {{"gains", "nominal", "nominal/errors.csv"}};
    case RunKind::kPlan:
      return {{"plan", ".", ""}};
    case RunKind::kCompare:
      break;
  }
  std::vector<SceneSet> sets;
  const CsvTable comparison = CsvTable::read(run_file(folder, "comparison.csv"));
  for (std::size_t c = 3; c < comparison.header().size(); ++c) {
    const std::string& name = comparison.header()[c];
    if (name.ends_with("/ratio")) break;
    sets.push_back({name, "rollouts_" + name, "errors_" + name + ".csv"});
  }
  return sets;
}

Scene scene_of(const std::vector<Scenario>& scenarios, std::vector<SceneSet> sets, double influence_radius) {
  Scene scene;
  scene.sets = std::move(sets);
  std::vector<std::string> known;  // the arm's own file and tool, as text
  for (const Scenario& scenario : scenarios) {
    SceneScenario s;
    s.name = scenario.name;
    s.duration = scenario.duration;
    s.path = scenario.path;
    s.obstacles.reserve(scenario.obstacles.size());
    for (const MovingObstacle& obstacle : scenario.obstacles)
      s.obstacles.push_back({obstacle.path, obstacle.radius});
    if (!s.obstacles.empty()) s.influence_radius = influence_radius;
    Arm arm = arm_of(*scenario.robot);
    Json json;
    write_arm(json, arm);
    for (s.arm = 0; s.arm < known.size() && known[s.arm] != json.str();) ++s.arm;
    if (s.arm == known.size()) {
      known.push_back(json.take());
      scene.arms.push_back(std::move(arm));
    }
    scene.scenarios.push_back(std::move(s));
  }
  return scene;
}

std::vector<Vec3> drawn_path(const Path& path) {
  constexpr int kPoints = 180;
  constexpr int kPointsOfKnots = 720;  // corners
  if (path.rests() || (!path.spline && !(path.period() > 0.0))) return {path.at(0.0).position};
  const int count = path.spline ? kPointsOfKnots : kPoints;
  const double turn = path.period();
  const double from = path.spline ? path.spline->begin() : 0.0;
  const double length = turn > 0.0 ? turn : path.spline->end() - from;
  std::vector<Vec3> points;
  points.reserve(2 * static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) points.push_back(path.at(from + length * i / count).position);
  if (turn > 0.0) return points;
  // Drawn closed: one that does not close goes back the way it came.
  for (int i = count; i > 0; --i) points.push_back(path.at(from + length * i / count).position);
  return points;
}

std::string scene_json(const Scene& scene) {
  Json json;
  json.begin_object();
  json.key("sets");
  json.begin_array();
  for (const SceneSet& set : scene.sets) {
    json.begin_object();
    json.text("name", set.name);
    json.text("folder", set.folder);
    json.text("errors", set.errors);
    json.end_object();
  }
  json.end_array();
  json.key("scenarios");
  json.begin_array();
  for (const SceneScenario& s : scene.scenarios) {
    json.begin_object();
    json.text("name", s.name);
    json.number("duration", s.duration);
    json.integer("robot", static_cast<long>(s.arm));
    json.key("path");
    write_path(json, s.path);
    json.key("obstacles");
    json.begin_array();
    for (const SceneObstacle& obstacle : s.obstacles) write_obstacle(json, obstacle);
    json.end_array();
    json.number("influence_radius", s.influence_radius);
    json.end_object();
  }
  json.end_array();
  json.key("robots");
  json.begin_array();
  for (const Arm& arm : scene.arms) write_arm(json, arm);
  json.end_array();
  json.end_object();
  return json.take() + '\n';
}

}  // namespace armtune::report
