#pragma once
// The commands that moved an arm while its log was recorded: torques, velocities or positions of its joints,
// or the reference of a controller.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/control/gains.hpp"
#include "core/control/laws/joint_drives.hpp"
#include "tuner/validation/joint_log.hpp"

namespace armtune::internal {

enum class CommandKind {
  kTorque,    ///< the torques of the joints
  kVelocity,  ///< velocities, which the drives of the robot model follow
  kPosition,  ///< positions, which the servo and the drives follow
  kReference  ///< desired positions of a controller, which is simulated with `gains`
};

/// Returns the name of a kind: "torque", "velocity", "position" or "reference".
const char* name(CommandKind kind);

/// M commands to n joints, in the joint order of the robot model. Each is held until the next one.
struct MotionCommands {
  CommandKind kind = CommandKind::kTorque;
  std::vector<double> time;  ///< M, increasing, on the clock of the log [s]
  Eigen::MatrixXd value;     ///< M x n [N m, N], [rad/s, m/s] or [rad, m]
  /// kTorque: true if the robot itself adds the torque that holds its weight, as Franka's arms do. Measured
  /// torques include this torque.
  bool robot_adds_weight = false;
  /// kPosition: the motion that the robot makes of streamed positions (position_servo.hpp). None: the drives
  /// follow the positions as they are.
  std::optional<ServoGains> servo = {};
  // The rest is for kReference only.
  Eigen::MatrixXd velocity = {};    ///< M x n, desired velocities [rad/s, m/s]; empty: differences are used
  std::optional<Gains> gains = {};  ///< of the controller; needed
  double control_period = 0.0;      ///< of the controller [s]; 0: the median time between references
};

/// Throws InputError with the log's source, the channel as key, the value and the limit in each of these
/// cases: fewer than two commands, sizes that differ, numbers that are not finite, times that do not
/// increase, a reference without gains, gains for another arm.
void check_motion_commands(const RobotModel& model, const JointLog& log, const MotionCommands& commands);

}  // namespace armtune::internal
