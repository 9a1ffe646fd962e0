#pragma once
// Mistakes that people make with logs: units, signs, columns, zero positions, the mounting, another arm. A
// log is read in the way that each mistake asks for, and the reading that an arm near the robot file's
// explains best is the likely one.

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
  ArmFit fit = {};  ///< with the log read as this mistake asks for
};

/// What a comparison of a log with the robot file found.
struct LogComparison {
  ArmFit as_logged;   ///< the nearest arm that explains the log, whatever its links
  ArmFit robot_file;  ///< the robot file's links, whatever its rotor inertia and friction
  /// False: too few joints move for their signs, zero positions and columns to be judged where the log is
  /// explained.
  bool most_joints_move = true;
  std::optional<LogMistake> mistake;  ///< none: the log may well be of this arm
};

/// Compares a log with the robot file. With mistakes to look for it takes a second or two, without one some
/// 50 ms.
/// noise (n): standard deviation of the noise of the instants' torques [N m, N].
LogComparison compare_with_robot_file(const RobotModel& model, const std::vector<LogInstant>& instants,
                                      const JointVector& noise);

/// One sentence that names the mistake, its joints and what to do.
std::string to_text(const LogMistake& mistake, const RobotModel& model);

}  // namespace armtune::internal
