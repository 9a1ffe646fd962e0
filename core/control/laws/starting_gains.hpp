#pragma once
// Computes start gains for an arm that has none, from its inertia, its limits and its size. They switch on
// armtune's extensions of the published law. A tuning starts from them; they are not its result.

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Returns the start gains. start, goal (n) [rad, m]: the joint positions between which the state
/// leaveSingularity moves the arm; goal lies on the task. manipulability: the smallest one on the task.
///
/// Kd of a joint is 25 /s times the inertia that it moves with the others free, 1 / (M^-1)_ii. M^-1 Kd then
/// has no eigenvalue above 25 n /s, which is possible with control periods of a few milliseconds. Kp is below
/// that rate, 5 /s of a joint and 15 /s of the task: S decays with M^-1 Kd, then the error with Kp (Slotine
/// and Li, Applied Nonlinear Control, section 9.2).
Gains starting_gains(const RobotModel& robot, const JointVector& start, const JointVector& goal,
                     double manipulability);

}  // namespace armtune::internal
