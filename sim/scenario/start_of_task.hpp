#pragma once
// The joint positions at the start of a task, on its path, and those at the start of a simulation, off it.

#include "core/control/pose_search.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Returns the desired position of the tool at `time`, and its desired orientation as far as the task
/// prescribes one.
ToolGoal tool_goal_at(const Scenario& scenario, double time);

/// Returns the joint positions (n) for the beginning of the task. The tool is on the path at
/// scenario.start_time and looks at the target that is active then. Among such positions it returns the one
/// whose walk along the task has the largest minimum of manipulability, away from the joint limits. Throws
/// InputError naming the place if there are none.
JointVector best_start_of_task(const Scenario& scenario);

/// Returns a position (n) in which a simulation begins if none is given. It is off `goal` by 20 degrees or
/// 0.1 m, a tenth of the joint's range at most, towards the middle of each joint's limits.
JointVector off_goal(const RobotModel& robot, const JointVector& goal);

}  // namespace armtune::internal
