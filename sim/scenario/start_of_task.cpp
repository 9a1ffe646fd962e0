#include "sim/scenario/start_of_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"
#include "core/robot/kinematics.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/path_walk.hpp"

namespace armtune::internal {
namespace {

constexpr double kMillimetres = 20.0;  // times the reach: no path in metres is that far away
constexpr double kAway = 20.0 * M_PI / 180.0;
constexpr double kAwaySliding = 0.1;   // m
constexpr double kAwayShare = 0.1;     // largest share of a joint's range
constexpr double kCentering = 0.2;     // 1/s, because no gains are known here
constexpr double kEnoughMargin = 0.1;  // share of a joint's range; a larger margin does not count as better

}  // namespace

ToolGoal tool_goal_at(const Scenario& scenario, double time) {
  ToolGoal goal{scenario.path.at(time).position, {}};
  if (!tracks_orientation(scenario.mask)) return goal;
  if (!scenario.orientation) {
    goal.target = scenario.targets[scenario.active_target(time)].path.at(time).position;
    return goal;
  }
  const Eigen::Quaterniond wanted = scenario.orientation->at(time, scenario.path).orientation;
  // For the axis alone, the goal is a point on the desired axis.
  if (scenario.mask == TaskMask::kPositionAndAxis) goal.target = goal.tool + wanted * Vec3::UnitZ();
  if (scenario.mask == TaskMask::kPose) goal.orientation = wanted;
  return goal;
}

JointVector best_start_of_task(const Scenario& scenario) {
  const ToolGoal goal = tool_goal_at(scenario, scenario.start_time);
  const auto best =
      best_pose(*scenario.robot, goal, sample_position(*scenario.robot, 0), [&](const JointVector& q) {
        const PathWalk walk = walk_path(scenario, q, kCentering);
        const double ease = walk.manipulability.value * std::min(1.0, walk.margin.value / kEnoughMargin);
        // If every walk fails, the pose whose walk has the smallest errors is chosen.
        return is_clear(walk) ? ease
                              : -1.0 - walk.error.value - std::max(0.0, -walk.margin.value) - depth(walk);
      });
  if (best) return *best;
  const Vec3& tool = goal.tool;
  throw InputError(
      InputPlace{shown_path(scenario.source), 0, "path"},
      fmt::format("{} cannot place its tool at ({:.4g}, {:.4g}, {:.4g}) m, where the path begins{}, "
                  "within its joint limits; move the path, or give start_position_deg{}",
                  scenario.robot->name, tool.x(), tool.y(), tool.z(),
                  scenario.orientation ? ", in the required orientation"
                  : goal.target        ? ", with its z axis on the target"
                                       : "",
                  tool.norm() > kMillimetres * reach(*scenario.robot)
                      ? ". If these are millimetres, declare this: units: {length: mm}"
                      : ""))
      .with_value(fmt::format("({:.4g}, {:.4g}, {:.4g})", tool.x(), tool.y(), tool.z()),
                  "a place that the tool can reach");
}

JointVector off_goal(const RobotModel& robot, const JointVector& goal) {
  JointVector start = goal;
  for (int i = 0; i < robot.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const JointLimits& limits = robot.joints[k].limits;
    const bool slides = robot.chain.motion[k] == JointMotion::kPrismatic;
    double away = slides ? kAwaySliding : kAway;
    if (limits.has_position) away = std::min(away, kAwayShare * (limits.upper - limits.lower));
    const double middle = limits.has_position ? 0.5 * (limits.lower + limits.upper) : 0.0;
    start[i] += goal[i] > middle ? -away : away;
  }
  return start;
}

}  // namespace armtune::internal
