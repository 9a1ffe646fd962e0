#pragma once
// Computes two sets of joint positions for a scenario that does not give them. In the first, the tool is at
// the start of its path. The second is some distance away from the first; the simulation begins there.

#include "core/control/pose_search.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Returns the desired position of the tool at `time`, and its desired orientation as far as the task
/// prescribes one.
ToolGoal tool_goal_at(const Scenario& scenario, double time);

/// Returns the joint positions (n) for the beginning of the task. The tool is on the path at
/// scenario.start_time and points at the target that is active then, or has the desired orientation. Among
/// such positions, this returns the one from which the arm follows the task best (path_walk.hpp): the one
/// whose smallest manipulability along the task is largest. Positions from which the arm comes close to a
/// joint limit are rated lower. Throws InputError naming the place of the tool if there are no such
/// positions.
JointVector best_start_of_task(const Scenario& scenario);

/// Returns joint positions (n) in which a simulation begins if none are given. Each joint is moved from
/// `goal` towards the middle of its limits, by 20 degrees or 0.1 m but by at most a tenth of its range.
JointVector off_goal(const RobotModel& robot, const JointVector& goal);

}  // namespace armtune::internal
