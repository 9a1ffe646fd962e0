#pragma once
// Computes start gains for an arm that has none. A gain on joint motion is the inertia that the joint moves,
// multiplied by a closed-loop rate [1/s] that the controllers of real arms reach. Kp of the task is itself
// such a rate.

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {

inline constexpr double kFirstRate = 25.0;      ///< decay of S = q' - qr' [1/s]
inline constexpr double kFirstTaskRate = 15.0;  ///< decay of the task's errors [1/s]
/// Ki of a law that does not adapt its model, as a share of Kp^2. It is a tenth of the share at which the
/// errors would start to oscillate.
inline constexpr double kFirstIntegralShare = 0.025;

/// Returns M(q) + D (n x n): the inertia matrix of the links plus the diagonal matrix of the rotor inertias.
JointMatrix mass_with_rotors(const RobotModel& robot, const JointVector& q);

/// Returns the inertia that each joint (n) moves at q while the other joints are free [kg m^2, kg]. It is
/// 1 / (M^-1)_ii, where M includes the rotors.
JointVector joint_inertia(const RobotModel& robot, const JointVector& q);

/// Sets the stiffness and damping (n) of springs and dampers on the joints. They are critically damped for
/// each joint with the others free, with both poles at half of kFirstRate.
void critically_damped(const RobotModel& robot, const JointVector& q, JointVector& stiffness,
                       JointVector& damping);

/// Returns the inertia that a force or moment at the tool moves along each axis of the base frame
/// [kg, kg m^2]. It is 1 / (J M^-1 J^T)_ii, and zero along an axis in which no joint moves the tool.
Vec6 task_inertia(const RobotModel& robot, const JointVector& q);

/// Sets Kp and Ki of the Cartesian references, if all of Kp is zero.
void first_references(Gains& gains);

/// Switches off the velocity governor and barrier, which controllers on robots do not have.
void without_velocity_limits(Gains& gains);

}  // namespace armtune::internal
