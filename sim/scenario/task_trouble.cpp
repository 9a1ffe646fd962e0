#include "sim/scenario/task_trouble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "armtune/error.hpp"
#include "core/control/pose_search.hpp"
#include "core/control/roll_centering.hpp"
#include "core/robot/kinematics.hpp"
#include "sim/scenario/start_of_task.hpp"

namespace armtune::internal {
namespace {

constexpr double kOffPath = 1e-3;  // m: a tool that is closer has reached its goal
constexpr unsigned kPlacesTried = 30;
constexpr int kTimesLooked = 20;    // number of times at which a lost path is checked
constexpr double kAtTarget = 0.02;  // m: closer to the target, the line to it turns faster than any tool can
constexpr const char* kMoveOrStartElsewhere = "move the path, or give another joint_space_goal";

/// Returns the smallest distance from the goal that was found for the tool, in any orientation [m].
double closest(const RobotModel& robot, const ToolGoal& goal) {
  double least = std::numeric_limits<double>::infinity();
  Poses poses;
  for (unsigned start = 0; start < kPlacesTried && least > kOffPath; ++start) {
    JointVector q = sample_position(robot, start);
    reach_goal(robot, {goal.tool, {}}, q);
    forward_kinematics(robot.chain, q, poses);
    least = std::min(least, (poses.p_0T - goal.tool).norm());
  }
  return least;
}

/// Returns true if the tool can be at the goal, whether or not the walk leads there.
bool can_reach(const RobotModel& robot, const ToolGoal& goal) {
  for (unsigned start = 0; start < kPlacesTried; ++start) {
    JointVector q = sample_position(robot, start);
    if (reach_goal(robot, goal, q)) return true;
  }
  return false;
}

std::string place(const WalkPlace& at) {
  return fmt::format("at {:.4g} s, at the path point ({:.4g}, {:.4g}, {:.4g}) m", at.time, at.tool.x(),
                     at.tool.y(), at.tool.z());
}

/// Returns the problem that the tool cannot reach a point of the path at all, after the point where the walk
/// lost the path. Returns an empty problem if there is no such point.
WalkTrouble out_of_reach(const PathWalk& walk, const Scenario& scenario) {
  WalkPlace farthest;
  std::optional<WalkPlace> turned_wrong;
  for (int look = 0; look < kTimesLooked; ++look) {
    const double time = walk.left.time + (walk.ended - walk.left.time) * look / (kTimesLooked - 1);
    const ToolGoal goal = tool_goal_at(scenario, time);
    const double distance = closest(*scenario.robot, goal);
    if (distance > std::max(kOffPath, farthest.value)) farthest = {time, goal.tool, distance};
    if (distance <= kOffPath && !turned_wrong && !can_reach(*scenario.robot, goal))
      turned_wrong = {time, goal.tool, 0.0};
  }
  const char* how = !tracks_orientation(scenario.mask) ? ""
                    : scenario.orientation             ? " and with the tool in its required orientation"
                                                       : " and with the tool's z axis on the target";
  if (farthest.value > kOffPath) {
    return {
        fmt::format("the path leaves the workspace of {} from {:.4g} s on: {}, the tool comes no closer to "
                    "it than {:.3g} m",
                    scenario.robot->name, walk.left.time, place(farthest), farthest.value),
        "move or shrink the path"};
  }
  if (!turned_wrong) return {};
  return {fmt::format("the path leaves the workspace that {} has within its joint limits{}, {}",
                      scenario.robot->name, how, place(*turned_wrong)),
          "move or shrink the path, or turn the tool differently"};
}

}  // namespace

WalkTrouble trouble(const PathWalk& walk, const Scenario& scenario) {
  if (is_clear(walk)) return {};
  if (walk.sight.value < kAtTarget) {
    return {fmt::format("the tool passes too close to its gaze target: {}, it is {:.3g} m away",
                        place(walk.sight), walk.sight.value),
            "move the path or the target"};
  }
  // The workspace is checked before singularities, because a path that leaves it stretches the arm into one.
  // Within the workspace, the damped inverse alone may lead the tool off the path.
  if (is_off_path(walk)) {
    if (WalkTrouble beyond = out_of_reach(walk, scenario); !beyond.problem.empty()) return beyond;
  }
  if (is_singular(walk)) {
    return {
        fmt::format("the path runs through a singularity of {}: {}, the manipulability is {:.3g}, while it "
                    "reaches {:.3g} elsewhere on the path",
                    scenario.robot->name, place(walk.manipulability), walk.manipulability.value,
                    walk.largest_manipulability),
        kMoveOrStartElsewhere};
  }
  if (is_off_path(walk)) {
    return {
        fmt::format("{} does not stay on the path: {}, the tool is {:.3g} m off, although the arm can reach "
                    "this point",
                    scenario.robot->name, place(walk.error), walk.error.value),
        kMoveOrStartElsewhere};
  }
  if (walk.margin.value >= 0.0) {
    const LeastClearance& touched = *contact(walk);
    return {fmt::format("{} touch at {:.4g} s on the path", scenario.clearance->name(*touched.pair),
                        touched.time),
            kMoveOrStartElsewhere};
  }
  return {fmt::format("joint {} exceeds its position limits on the path by {:.2g} of its range, {}",
                      scenario.robot->joints[static_cast<std::size_t>(walk.joint)].name, -walk.margin.value,
                      place(walk.margin)),
          kMoveOrStartElsewhere};
}

TaskTrouble find_task_trouble(const Scenario& scenario, const Gains& gains) {
  if (scenario.planned) return {};
  JointVector q = in_si(*scenario.robot, with_goal(gains, scenario).joint_space_goal);
  if (!reach_goal(*scenario.robot, tool_goal_at(scenario, scenario.start_time), q)) {
    try {
      q = best_start_of_task(scenario);
    } catch (const InputError& error) {
      return {error.what()};
    }
  }
  const PathWalk walk = walk_path(scenario, q, gains.joint_centering_gain, gains.roll_centering_gain);
  const bool leaves_limits = !is_off_path(walk) && !is_singular(walk) && walk.margin.value < 0.0;
  // Without roll control, the roll of a gaze drifts and moves the last joint. Roll control can prevent this.
  const bool roll_drifts = walk.joint == scenario.robot->n() - 1 &&
                           RollCentering(*scenario.robot, 1.0, scenario.mask).is_on() &&
                           !scenario.orientation && gains.roll_centering_gain == 0.0;
  return {trouble(walk, scenario).text(), leaves_limits && !roll_drifts};
}

}  // namespace armtune::internal
