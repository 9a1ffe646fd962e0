#pragma once
// ROS's joint_trajectory_controller on an effort interface.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

/// What this kind is called.
inline constexpr const char* kJointTrajectoryController = "joint_trajectory_controller";

/// Each joint has a PID on its errors along the desired motion, and a share of the desired velocity:
///   tau_i = p e_i + clamp(i integral of e_i, +-i_clamp) + d e_i' + ff_velocity_scale qd_i'(t + period),
///   e = qd - q.
/// The law knows nothing of the arm, not even its weight. Of ros2_controllers, branch `jazzy` (16 August
/// 2026); `humble` takes the desired velocity of t. See ros_pid.hpp for what the integral does.
ControllerKind joint_trajectory_controller();

}  // namespace armtune::internal
