#pragma once
// Computes start gains for an arm that has none. A gain on joint motion is the inertia that the joint moves,
// multiplied by a rate [1/s] that the controllers of real arms reach. Kp of the task is such a rate itself.

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

inline constexpr double kFirstRate = 25.0;      ///< decay of S = q' - qr' [1/s]
inline constexpr double kFirstTaskRate = 15.0;  ///< decay of the task's errors [1/s]
/// Ki of a law that does not adapt its model, as a share of Kp^2. It is a tenth of the share at which the
/// errors would start to oscillate.
inline constexpr double kFirstIntegralShare = 0.025;

/// Returns M(q) + D (n x n).
JointMatrix mass_with_rotors(const RobotModel& robot, const JointVector& q);

/// Returns the inertia that each joint (n) moves at q with the others free, 1 / (M^-1)_ii [kg m^2, kg].
JointVector joint_inertia(const RobotModel& robot, const JointVector& q);

/// Returns the inertia against a force or moment at the tool along each axis of the base frame,
/// 1 / (J M^-1 J^T)_ii [kg, kg m^2]; zero along an axis in which no joint moves the tool.
Vec6 task_inertia(const RobotModel& robot, const JointVector& q);

/// Sets Kp and Ki of the Cartesian references, if all of Kp is zero.
void first_references(Gains& gains);

}  // namespace armtune::internal
