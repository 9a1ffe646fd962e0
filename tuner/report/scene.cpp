#include "tuner/report/scene.hpp"

#include <algorithm>

#include "armtune/error.hpp"
#include "sim/scenario/walk_extremes.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::report {
namespace {

ArmShape drawn(const CellPart& part) {
  ArmShape shape;
  shape.pose.q = Eigen::Quaterniond(part.R_0S).normalized();
  const Vec3& size = part.solid.size;
  switch (part.solid.kind) {
    case SolidKind::kSphere:
      shape.kind = ShapeKind::kSphere;
      shape.size = {part.solid.radius};
      break;
    case SolidKind::kCapsule:
      shape.kind = ShapeKind::kCapsule;
      shape.size = {part.solid.radius, size.x()};
      break;
    case SolidKind::kCylinder:
      shape.kind = ShapeKind::kCylinder;
      shape.size = {size.x(), size.y()};
      break;
    default:
      shape.kind = ShapeKind::kBox;
      shape.size = {size.x(), size.y(), size.z()};
  }
  return shape;
}

/// Returns start and result. If armtune replaced the study's own start gains, these are between them.
std::vector<SceneSet> tune_sets(const std::string& folder) {
  std::vector<SceneSet> sets = {{"start", "start", "start/errors.csv"}};
  if (find_run_file(folder, "given/gains.yaml")) sets.push_back({"given", "given", "given/errors.csv"});
  sets.push_back({"tuned", ".", "errors.csv"});
  return sets;
}

}  // namespace

std::vector<SceneSet> usual_sets(RunKind kind, const std::string& folder) {
  switch (kind) {
    case RunKind::kTune:
      return tune_sets(folder);
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
    default:  // a validation or a calibration, which have no gains, or a run without a page
      return {};
  }
  std::vector<SceneSet> sets;
  const auto run = find_run_record(folder);
  if (!run || !run->compare) {
    throw InputError(InputPlace{folder + "/" + kRunRecord, 0, "compare"},
                     "does not name the gain sets that were compared; repeat the comparison");
  }
  for (const std::string& name : run->compare->sets)
    sets.push_back({name, "rollouts_" + name, "errors_" + name + ".csv"});
  return sets;
}

Scene scene_of(const std::vector<Scenario>& scenarios, std::vector<SceneSet> sets, double influence_radius) {
  Scene scene;
  scene.sets = std::move(sets);
  for (const Scenario& scenario : scenarios) {
    SceneScenario s;
    s.name = scenario.name;
    s.duration = scenario.duration;
    s.path = scenario.path;
    s.obstacles.reserve(scenario.obstacles.size());
    for (const MovingObstacle& obstacle : scenario.obstacles)
      s.obstacles.push_back({obstacle.path, obstacle.radius});
    if (!s.obstacles.empty()) s.influence_radius = influence_radius;
    if (scenario.clearance) {
      for (const CellPart& part : scenario.clearance->cell().parts) {
        if (!part.is_obstacle) s.cell.push_back({part.name, drawn(part), part.path});
      }
      // The floor is drawn perpendicular to the base frame's z axis.
      const bool upright = height_of(Vec3::UnitZ(), *scenario.robot) > 1.0 - 1e-6;
      if (upright) s.floor = scenario.clearance->cell().floor;
    }
    Arm arm = arm_of(*scenario.robot);
    const auto known = std::find(scene.arms.begin(), scene.arms.end(), arm);
    s.arm = static_cast<std::size_t>(known - scene.arms.begin());
    if (known == scene.arms.end()) scene.arms.push_back(std::move(arm));
    scene.scenarios.push_back(std::move(s));
  }
  return scene;
}

std::vector<Vec3> drawn_path(const Path& path) {
  constexpr int kPoints = 180;
  constexpr int kPointsOfKnots = 720;  // corners
  const auto at = [&path](double t) { return Vec3((1e5 * path.at(t).position).array().round() / 1e5); };
  if (path.rests() || (!path.spline && !(path.period() > 0.0))) return {at(0.0)};
  const int count = path.spline ? kPointsOfKnots : kPoints;
  const double turn = path.period();
  const double from = path.spline ? path.spline->begin() : 0.0;
  const double length = turn > 0.0 ? turn : path.spline->end() - from;
  std::vector<Vec3> points;
  points.reserve(2 * static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) points.push_back(at(from + length * i / count));
  if (turn > 0.0) return points;
  // The polyline is drawn closed. A path that does not close goes back the way it came.
  for (int i = count; i > 0; --i) points.push_back(at(from + length * i / count));
  return points;
}

}  // namespace armtune::internal::report
