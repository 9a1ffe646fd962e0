#pragma once
// Plans the motion of an arm through joint goals that have no times.

#include "tuner/controller_study/controller_study.hpp"

namespace armtune::internal {

/// Returns a motion that begins at 0 s at rest at the first goal, goes to each next goal in the least time
/// that the limits below allow, and rests there for 0.5 s. Its acceleration is linear between knots. Limits:
///   - 80 % of the robot's velocity and effort limits;
///   - the robot's acceleration limits, if it has any, and in any case no more than reaches the permitted
///     velocity within 0.5 s;
///   - a jerk that reaches this acceleration within 0.1 s;
///   - the distances of a planning task: 2 cm from the parts of the cell and the floor, and links do not
///   touch
///     each other. Like the torque, they are checked at 60 times of each move, not between them.
/// Throws InputError naming file and goal if a goal breaks these limits, or if no motion is found.
TimedGoals time_goals(const JointGoals& goals);

}  // namespace armtune::internal
