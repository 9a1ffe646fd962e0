#pragma once
// Joint impedance control, as in the example controllers for Franka's arms and in controllers that command
// torques on UR robots. armtune simulates this law to tune gains for the real controller.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

inline constexpr const char* kJointImpedance = "joint_impedance";

/// Makes the kind of controller `joint_impedance`. A spring and a damper pull each joint to the desired
/// motion:
///   c = k (qd - q) + D (velocity_factor * qd' - v) + coriolis_factor * C(q, q') q',
///   D = d + 2 r sqrt(k),   v = f v_last + (1 - f) q',   tau = g(q) + c,
/// where r is a damping ratio, and c is limited to change by at most torque_rate times the period from one
/// period to the next. v and c start at 0, as on the robot. g(q) and C follow from the controller's model of
/// the arm, without friction; robots with a torque interface add g(q) themselves. Source: franka_ros,
/// joint_impedance_example_controller.cpp, commit c11f000 (28 March 2024), with r = 0, f = 0.01 and a
/// torque_rate of 1000 N m/s (here the default is 0: no limit). The examples of franka_ros2 (40cf08b) have a
/// velocity_factor of 0.
ControllerKind joint_impedance_controller();

}  // namespace armtune::internal
