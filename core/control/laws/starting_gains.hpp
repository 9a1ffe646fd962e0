#pragma once
// Gains to begin with on an arm that has none: from its inertia, its limits and its size, under the extended
// law. A tuning's start, not its end.

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// start, goal (n) [rad, m]: of leaveSingularity; goal lies on the task. manipulability: the smallest that
/// the task has.
///
/// Kd of a joint is 25 /s times the inertia it feels with the others free, 1 / (M^-1)_ii: M^-1 Kd has then no
/// eigenvalue above 25 n /s, which periods of a few milliseconds can hold. Kp is below that rate,
/// 5 /s of a joint and 15 /s of the task (Slotine and Li, Applied Nonlinear Control, section 9.2: S dies with
/// M^-1 Kd, then the error with Kp).
Gains starting_gains(const RobotModel& robot, const JointVector& start, const JointVector& goal,
                     double manipulability);

}  // namespace armtune::internal
