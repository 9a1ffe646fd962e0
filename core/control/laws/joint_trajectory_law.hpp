#pragma once
// ROS's joint_trajectory_controller on an effort or a velocity interface.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

/// What the kinds are called: with effort and with velocity commands.
inline constexpr const char* kJointTrajectoryController = "joint_trajectory_controller";
inline constexpr const char* kJointTrajectoryVelocityController = "joint_trajectory_controller_velocity";

/// Returns true for both of them.
bool is_joint_trajectory_controller(const std::string& kind);

/// The name of such a kind's own gain, of what the controller's documentation calls p, i, d, i_clamp,
/// ff_velocity_scale, or of "antiwindup": for example jtc_p, or jtc_velocity_p.
std::string jtc_name(const std::string& kind, const std::string& what);
/// And its numbers. Throws InputError for gains of another kind.
const JointVector& jtc_gain(const Gains& gains, const std::string& what);
JointVector& jtc_gain(Gains& gains, const std::string& what);

/// Each joint has a PID on its errors along the desired motion, and a share of the desired velocity:
///   tau_i = p e_i + clamp(i integral of e_i, +-i_clamp) + d e_i' + ff_velocity_scale qd_i'(t + period),
///   e = qd - q.
/// The law knows nothing of the arm, not even its weight; a robot with compensates_gravity adds that. Of
/// ros2_controllers, branch `jazzy` (16 August 2026); `humble` takes the desired velocity of t. See
/// ros_pid.hpp for what the integral does.
ControllerKind joint_trajectory_controller();

/// The same, but what the PID gives is a velocity, which the joints' drives follow (velocity_drive.hpp). They
/// begin with the torque that holds the arm, as the controller's model of it has that.
ControllerKind joint_trajectory_velocity_controller();

}  // namespace armtune::internal
