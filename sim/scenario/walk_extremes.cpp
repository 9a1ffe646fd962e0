#include "sim/scenario/walk_extremes.hpp"

#include <algorithm>

#include "core/control/pose_search.hpp"
#include "core/robot/holding_load.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {
namespace {

/// Returns the distance of a point from the line segment between a and b [m].
double distance_from_line(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 line = b - a;
  const double length_squared = line.squaredNorm();
  const double share =
      length_squared > 0.0 ? std::clamp((point - a).dot(line) / length_squared, 0.0, 1.0) : 0.0;
  return (point - a - share * line).norm();
}

double lowest(const RobotModel& robot, const Poses& poses) {
  double height = height_of(poses.p_0T, robot);
  for (int i = 2; i < robot.n(); ++i)
    height = std::min(height, height_of(poses.p_0B[static_cast<std::size_t>(i)], robot));
  return height;
}

/// Returns the distance of the tool from the nearest link [m]. The last links do not count, because they are
/// always close to the tool.
double folded(const Poses& poses) {
  double least = distance_from_line(poses.p_0T, Vec3::Zero(), poses.p_0B[0]);
  for (int i = 0; i + 3 < poses.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    least = std::min(least, distance_from_line(poses.p_0T, poses.p_0B[k], poses.p_0B[k + 1]));
  }
  return least;
}

void take_larger(const WalkPlace& place, WalkPlace& found) {
  if (!(place.value <= found.value)) found = place;
}

}  // namespace

double height_of(const Vec3& point, const RobotModel& robot) {
  return -point.dot(robot.chain.gravity.normalized());
}

void take_smaller(const WalkPlace& place, WalkPlace& found) {
  if (!(place.value >= found.value)) found = place;
}

WalkExtremes::WalkExtremes(const Scenario& scenario, double off_path, const std::vector<double>& required)
    : robot_(*scenario.robot),
      off_path_(off_path),
      loaded_(with_payload(robot_, scenario.plant.payload).chain),
      efforts_(robot_.effort_limits()) {
  if (scenario.clearance) cell_.emplace(scenario.clearance, required);
}

void WalkExtremes::see(double time, const Vec3& tool, const MeasuredArm& arm, const JointVector& q,
                       PathWalk& walk) {
  const double off = (arm.poses.p_0T - tool).norm();
  const double manipulability = arm.inverse.manipulability();
  if (!(off <= off_path_) && walk.left.value == 0.0) walk.left = {time, tool, off};
  take_larger({time, tool, off}, walk.error);
  take_smaller({time, tool, manipulability}, walk.manipulability);
  walk.largest_manipulability = std::max(walk.largest_manipulability, manipulability);
  const TightestJoint tightest = tightest_joint(robot_, q);
  if (!(tightest.margin >= walk.margin.value)) walk.joint = tightest.joint;
  take_smaller({time, tool, tightest.margin}, walk.margin);
  take_smaller({time, tool, lowest(robot_, arm.poses)}, walk.low);
  take_smaller({time, tool, folded(arm.poses)}, walk.fold);
  if (cell_) {
    cell_->see(time, q);
    walk.nearest = cell_->least();
  }
  const HoldingLoad load = holding_load(loaded_, arm.poses, efforts_, gravity_);
  if (!(load.share <= walk.load.value)) walk.loaded = load.joint;
  take_larger({time, tool, load.share}, walk.load);
}

void WalkExtremes::finish(PathWalk& walk) const {
  if (cell_) walk.too_near = cell_->too_near();
}

}  // namespace armtune::internal
