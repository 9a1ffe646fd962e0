#pragma once
// Computes joint positions for scenarios that do not give them: those with the tool on the start of its path,
// and those away from it from which a simulation begins.

#include "core/control/pose_search.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Returns the desired position of the tool at `time`, and its desired orientation as far as the task
/// prescribes one.
ToolGoal tool_goal_at(const Scenario& scenario, double time);

/// Returns the joint positions (n) for the beginning of the task. The tool is on the path at
/// scenario.start_time and points at the target that is active then, or has the desired orientation. Among
/// such positions, this returns the one from which the arm follows the task best: with the largest minimum of
/// manipulability, away from the joint limits (path_walk.hpp). Throws InputError naming the place if there
/// are none.
JointVector best_start_of_task(const Scenario& scenario);

/// Returns joint positions (n) in which a simulation begins if none are given. Each joint differs from `goal`
/// by 20 degrees or 0.1 m, a tenth of its range at most, towards the middle of its limits.
JointVector off_goal(const RobotModel& robot, const JointVector& goal);

}  // namespace armtune::internal
