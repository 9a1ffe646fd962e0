#pragma once
// Start gains computed from the inertia that each joint moves: the inertia times a bandwidth [1/s] that the
// controllers of real arms reach.

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

inline constexpr double kFirstRate = 25.0;      ///< [1/s], for S
inline constexpr double kFirstTaskRate = 15.0;  ///< [1/s], for the task's errors
/// Ki of a law that does not learn, as a share of Kp^2: a tenth of the share at which it would oscillate.
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
