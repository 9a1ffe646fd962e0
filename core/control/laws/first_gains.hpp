#pragma once
// Gains to begin with follow the inertia that is to be moved: rates that an arm's controller can hold, times
// what it feels.

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

inline constexpr double kFirstRate = 25.0;      ///< [1/s], of S
inline constexpr double kFirstTaskRate = 15.0;  ///< [1/s], of the task's errors
/// Ki of a law that learns nothing, of Kp^2: a tenth of the way to where it would oscillate.
inline constexpr double kFirstIntegralShare = 0.025;

/// M(q) + D (n x n).
JointMatrix mass_with_rotors(const RobotModel& robot, const JointVector& q);

/// What each joint (n) feels at q with the others free, 1 / (M^-1)_ii [kg m^2, kg].
JointVector joint_inertia(const RobotModel& robot, const JointVector& q);

/// What a force or moment along each axis of the base frame feels at the tool, 1 / (J M^-1 J^T)_ii [kg,
/// kg m^2]; zero along an axis in which no joint moves it.
Vec6 task_inertia(const RobotModel& robot, const JointVector& q);

/// Sets Kp and Ki of the Cartesian references where they are zero.
void first_references(Gains& gains);

}  // namespace armtune::internal
