#pragma once
// Computes start gains for an arm that has none, from its inertia, its limits and its size. The gains switch
// on armtune's extensions of the published law. A tuning search starts from them.

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Returns the start gains. start, goal (n) [rad, m]: the joint positions between which the state
/// leaveSingularity moves the arm; goal lies on the task. manipulability: smallest manipulability on the
/// task.
///
/// Kd of a joint is 25 /s times the inertia that it moves while the other joints are free, 1 / (M^-1)_ii.
/// M^-1 Kd then has no eigenvalue above 25 n /s, which is possible with control periods of a few
/// milliseconds. Kp is a smaller rate, 5 /s for joints and 15 /s for the task, because the error decays with
/// the rate Kp only after S has decayed with the rates of M^-1 Kd (Slotine and Li, Applied Nonlinear Control,
/// section 9.2).
Gains starting_gains(const RobotModel& robot, const JointVector& start, const JointVector& goal,
                     double manipulability);

}  // namespace armtune::internal
