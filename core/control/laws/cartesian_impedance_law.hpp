#pragma once
// Cartesian impedance control, in the form of the example controllers for Franka's arms and the
// controllers derived from them have it. It has no feed-forward: the tool hangs on a spring and a damper.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

inline constexpr const char* kCartesianImpedance = "cartesian_impedance";

/// Makes the kind of this name. A spring and a damper act on the tool, others on the joint motion that the
/// task leaves free:
///   tau = g(q) + (C(q, q') q' - J^T (K e + D J q') + N (k_N (q_N - q) - 2 sqrt(k_N) q')),
///   D = 2 r sqrt(K),   N = 1 - J^T (J J^T + 0.04)^-1 J,
/// where r is the damping ratio. The part in brackets changes by at most torque_rate times the period.
/// e is the pose error [m, 1]. Its rotational part is sin(angle / 2) times the axis of the turn, so a
/// rotational stiffness acts with half of its value on small errors. The desired pose is filtered,
/// d = f d_last + (1 - f) x_d (rotations by slerp). d and q_N begin as the pose and the joint positions at
/// which the law first tracks the tool. Where the task has fewer than six components, J and e have only
/// those. In states that track joints, the torque is Y theta - Kd S instead. g(q) and C follow from the
/// controller's model of the arm, without friction; robots with a torque interface add g(q) themselves.
/// Source: franka_ros, cartesian_impedance_example_controller.cpp, commit c11f000, with r = 1, f = 0.995 and
/// a torque_rate of 1000 N m/s. There the filtered pose acts one period later.
ControllerKind cartesian_impedance_controller();

}  // namespace armtune::internal
