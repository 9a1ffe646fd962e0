#pragma once
// Where an arm stands when it begins: at its task, and for a simulation beside its goal.

#include "core/control/pose_search.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Where the tool is to be at `time`, and how it is to be turned as far as the task asks for it.
ToolGoal tool_goal_at(const Scenario& scenario, double time);

/// The joint positions (n) to begin the task at: the tool on the path at scenario.start_time, looking at the
/// target that is active then, from where the smallest manipulability of the walk is the largest, away from
/// the limits. Throws InputError if there are none, naming the place.
JointVector best_start_of_task(const Scenario& scenario);

/// A position (n) to begin a simulation with when none is given: off `goal` by 20 degrees or 0.1 m, a tenth
/// of the joint's range at most, towards the middle of each joint's limits.
JointVector off_goal(const RobotModel& robot, const JointVector& goal);

}  // namespace armtune::internal
