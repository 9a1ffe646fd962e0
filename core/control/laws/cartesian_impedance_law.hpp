#pragma once
// Cartesian impedance control, as in the example controllers for Franka's arms and in the controllers that
// are derived from them. A spring and a damper hold the tool at its desired pose; there is no feed-forward.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

inline constexpr const char* kCartesianImpedance = "cartesian_impedance";

/// Makes the kind of controller `cartesian_impedance`. A spring and a damper act on the tool. A second pair
/// acts on the joint motion that the task leaves free:
///   tau = g(q) + (C(q, q') q' - J^T (K e + D J q') + N (k_N (q_N - q) - 2 sqrt(k_N) q')),
///   D = d + 2 r sqrt(K),   N = 1 - J^T (J J^T + 0.04)^-1 J,
/// where r is the damping ratio, and d an additional damping that does not depend on K. The part in brackets
/// changes by at most torque_rate times the period from one period to the next. e is the pose error [m, 1].
/// Its rotational part is sin(angle / 2) times the axis of the turn, so a rotational stiffness acts with half
/// of its value on small errors. The desired pose x_d is filtered, x_f = f x_f_last + (1 - f) x_d (rotations
/// by slerp), and e is the error from the filtered pose x_f. When the law starts to track the tool, x_f is
/// the present pose, and q_N is set to the present joint positions. If the task has fewer than six
/// components, J and e contain only these. In states that track joints, the torque is Y theta - Kd S instead.
/// g(q) and C follow from the controller's model of the arm, without friction; robots with a torque interface
/// add g(q) themselves. Source: franka_ros, cartesian_impedance_example_controller.cpp, commit c11f000, with
/// d = 0, r = 1, f = 0.995 and a torque_rate of 1000 N m/s. There the filtered pose acts one period later.
ControllerKind cartesian_impedance_controller();

}  // namespace armtune::internal
