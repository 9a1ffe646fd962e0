#pragma once
// Finds common mistakes with logs: units, signs, columns, zero positions, the mounting, another arm.
// For each mistake the log is read as if the mistake had been made. The reading that an arm near the robot
// file's explains best is the likely one.

#include <optional>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "tuner/identification/arm_fit.hpp"

namespace armtune::internal {

enum class MistakeKind {
  kTorqueScale,       ///< torques have to be multiplied by `value`
  kAllTorqueSigns,    ///< every torque has the other sign
  kTorqueSign,        ///< the torque of `joint` has the other sign
  kTorquesSwapped,    ///< the torques of `joint` and `other` are exchanged
  kDegrees,           ///< positions are in degrees
  kPositionSign,      ///< the position of `joint` has the other sign
  kJointSign,         ///< position and torque of `joint` have the other sign
  kPositionOffset,    ///< `value` [rad] has to be added to the position of `joint`
  kPositionsSwapped,  ///< the positions of `joint` and `other` are exchanged
  kMounting,          ///< gravity points along `direction` in the base frame
  kAnotherArm,        ///< none of these: the log is of another arm, or the robot file is far from the arm
};

struct LogMistake {
  MistakeKind kind = MistakeKind::kAnotherArm;
  int joint = -1;
  int other = -1;
  double value = 0.0;
  Vec3 direction = Vec3::Zero();
  ArmFit fit = {};  ///< fit of the log after this mistake is corrected
};

/// The result of a comparison of a log with the robot file.
struct LogComparison {
  ArmFit as_logged;   ///< the nearest arm that explains the log, whatever its links
  ArmFit robot_file;  ///< the robot file's links, whatever its rotor inertia and friction
  /// True if at least half of the joints move. Otherwise signs, zero positions and columns cannot be judged
  /// in a log that is explained.
  bool most_joints_move = true;
  std::optional<LogMistake> mistake;  ///< none: the log may well be of this arm
};

/// Compares a log with the robot file. It takes some 50 ms, or a second or two if mistakes have to be looked
/// for. noise (n): standard deviation of the noise of the instants' torques [N m, N].
LogComparison compare_with_robot_file(const RobotModel& model, const std::vector<LogInstant>& instants,
                                      const JointVector& noise);

/// Returns one sentence that names the mistake, its joints and what to do.
std::string to_text(const LogMistake& mistake, const RobotModel& model);

}  // namespace armtune::internal
