#pragma once
// The control law of joint impedance control, as the example controllers for Franka's arms and UR's torque
// interface have it. Gains for the real controller are tuned with it.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

inline constexpr const char* kJointImpedance = "joint_impedance";

/// Makes the kind of this name. Each joint is a spring and a damper along the desired motion:
///   c = k (qd - q) + d (velocity_factor qd' - v) + coriolis_factor C(q, q') q',   v = f v_last + (1 - f) q',
///   tau = g(q) + (c, changed by at most torque_rate times the period).
/// v, and c before the first period, begin at 0, as on the robot. g(q) and C follow from the controller's
/// model of the arm, without friction; robots with a torque interface add g(q) themselves. Source:
/// franka_ros, joint_impedance_example_controller.cpp, commit c11f000 (28 March 2024), with f = 0.01 and a
/// torque_rate of 1000 N m/s (here the default is 0: no limit). The examples of franka_ros2 (40cf08b) have a
/// velocity_factor of 0.
ControllerKind joint_impedance_controller();

}  // namespace armtune::internal
