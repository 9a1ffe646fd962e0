#pragma once
// Computes the torques that logged commands give a simulated arm: directly, through the drives of the robot
// model, or through a controller.

#include <memory>

#include "core/robot/robot_model.hpp"
#include "tuner/validation/motion_commands.hpp"

namespace armtune::internal {

/// The state of an arm at which a simulation starts.
struct ArmStart {
  double time = 0.0;  ///< on the clock of the log [s]
  JointVector q, qd;  ///< n [rad, m; rad/s, m/s]
  JointVector qdd;    ///< n [rad/s^2, m/s^2]
};

class CommandFollower {
 public:
  CommandFollower() = default;
  CommandFollower(const CommandFollower&) = delete;
  CommandFollower& operator=(const CommandFollower&) = delete;
  virtual ~CommandFollower() = default;

  /// Time between two calls of torque() [s].
  virtual double step() const = 0;
  /// Begins a window. The start must stay in place until the next one.
  virtual void start(const ArmStart& from) = 0;
  /// Computes the torques (n) [N m, N] that act in the step number k of the window, counted from 0, within
  /// the effort limits. q, qd (n): state at the beginning of the step.
  virtual void torque(long k, const JointVector& q, const JointVector& qd, JointVector& tau) = 0;
};

/// Makes the follower for these commands. sample_period: time between samples of the log [s]. It is a
/// multiple of the follower's step unless a controller is simulated. All references must outlive the result.
std::unique_ptr<CommandFollower> make_command_follower(const RobotModel& model,
                                                       const MotionCommands& commands, double sample_period);

/// Follows torque commands.
std::unique_ptr<CommandFollower> make_torque_follower(const RobotModel& model, const MotionCommands& commands,
                                                      double step);
/// Follows velocity or position commands through the drives of the robot model. So that the torque does not
/// jump at the start, the integrals of the drives start with the torques with which the model has the logged
/// acceleration there. The servo or interpolation of positions has run over the commands before the start.
std::unique_ptr<CommandFollower> make_drive_follower(const RobotModel& model, const MotionCommands& commands,
                                                     double step);
/// Follows a reference with a controller. The integrals of the controller and of its drives start as at rest.
std::unique_ptr<CommandFollower> make_controller_follower(const RobotModel& model,
                                                          const MotionCommands& commands);

}  // namespace armtune::internal
