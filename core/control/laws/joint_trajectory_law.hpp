#pragma once
// The control laws of ROS's joint_trajectory_controller with an effort or a velocity interface. armtune
// simulates them to tune gains for the real controller.

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/jtc_command.hpp"
#include "core/control/laws/ros_distro.hpp"

namespace armtune::internal {

/// Names of the two kinds: with effort and with velocity commands.
inline constexpr const char* kJointTrajectoryController = "joint_trajectory_controller";
inline constexpr const char* kJointTrajectoryVelocityController = "joint_trajectory_controller_velocity";

/// True for either of these names.
bool is_joint_trajectory_controller(const std::string& kind);

/// Returns armtune's name of one of the gains of such a kind. what: p, i, d, i_clamp or ff_velocity_scale, as
/// in the controller's documentation, or "antiwindup". Examples: jtc_p, jtc_velocity_p.
std::string jtc_name(const std::string& kind, const std::string& what);
/// Returns the values of that gain. Throws InputError for gains of another kind.
const JointVector& jtc_gain(const Gains& gains, const std::string& what);
JointVector& jtc_gain(Gains& gains, const std::string& what);

/// Returns the distribution of ROS whose rules gains of such a kind follow.
RosDistro jtc_distro(const Gains& gains);
/// Returns the absolute value of the lower bound of the integral's contribution for a joint.
double jtc_lower_i_clamp(const Gains& gains, Eigen::Index joint);

/// For the kind with effort commands, multiplies the integral gain i of each joint by i_clamp / effort limit
/// where this is a reduction. A gain of i = p / (1 s) then has the same effect for every clamp: at the
/// position error at which p alone gives the effort limit, the integral reaches its clamp in 1 s. A larger i
/// would only switch the integral between its clamps. Where ROS lets the integral grow beyond them, it would
/// also take long to return. Leaves gains of other kinds unchanged.
void fit_integral_to_clamp(const RobotModel& model, Gains& gains);

/// True if the feed-forward with these gains uses the desired velocity of the next period of a planned
/// motion, not that of the present one. False for gains of other kinds.
bool feeds_next_velocity(const Gains& gains);

/// Returns the numbers of the law with these gains. The gains must be of such a kind, and valid for the
/// robot.
JtcNumbers jtc_numbers(const RobotModel& model, const Gains& gains);

/// Makes the kind with effort commands. Each joint has a PID on its error from the desired motion, and a
/// feed-forward of the desired velocity:
///   tau_i = p e_i + clamp(i int(e_i), +-i_clamp) + d e_i' + ff_velocity_scale * qd_i'(t + period),
///   e = qd - q,   qd: desired positions.
/// The law has no model of the arm and does not compensate its weight. A robot with compensates_gravity adds
/// the torque for the weight itself. The equation is that of ROS 2 Jazzy. The gain jtc_distro selects the
/// rules of Humble or of ROS 1 instead (ros_distro.hpp). For the integral see ros_pid.hpp.
ControllerKind joint_trajectory_controller();

/// Makes the kind with velocity commands. The output of the PID is a velocity, which the joints' drives
/// follow (velocity_drive.hpp). At the start, the drives give the torque that holds the arm, computed with
/// the controller's model of the arm. If the robot compensates gravity, they start without this torque.
ControllerKind joint_trajectory_velocity_controller();

}  // namespace armtune::internal
