#pragma once
// Finds common mistakes in a robot's logs before its parameters are identified from them: wrong units, signs,
// columns, zero positions or mounting, or a log of another arm. Each possible mistake is tentatively
// corrected, and an arm with parameters close to those of the robot file is fitted to the corrected log. The
// mistake whose correction gives the best fit is the most likely one.

#include <optional>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "tuner/identification/arm_fit.hpp"

namespace armtune::internal {

enum class MistakeKind {
  kTorqueScale,       ///< the torque of `joint`, or all torques, have to be multiplied by `value`
  kAllTorqueSigns,    ///< every torque has the other sign
  kTorqueSign,        ///< the torque of `joint` has the other sign
  kTorquesSwapped,    ///< the torques of `joint` and `other` are exchanged
  kDegrees,           ///< positions are in degrees
  kMixedUnits,        ///< positions were read as degrees: that of `joint` was in degrees, others in radians
  kPositionSign,      ///< the position of `joint` has the other sign
  kJointSign,         ///< position and torque of `joint` have the other sign
  kPositionOffset,    ///< `value` [rad] has to be added to the position of `joint`
  kPositionsSwapped,  ///< the positions of `joint` and `other` are exchanged
  kGearRatio,         ///< the position of `joint` has to be multiplied, and its torque divided, by `value`
  kMounting,          ///< gravity points along `direction` in the base frame
  kNoWeight,          ///< the torques do not include those that hold the arm's weight
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
  ArmFit as_logged;   ///< fit of links, rotor inertia and friction to the unchanged log
  ArmFit robot_file;  ///< fit of rotor inertia and friction alone, with the links of the robot file
  /// True if at least half of the joints move. If fewer joints move and some arm close to the robot file
  /// explains the log, wrong signs, zero positions and columns cannot be detected.
  bool most_joints_move = true;
  std::optional<LogMistake> mistake;  ///< none: the log seems to be of this arm
};

/// Compares a log with the robot file. This takes some 50 ms, or up to a few seconds if it has to look for
/// mistakes. noise (n): standard deviation of the noise in the instants' torques [N m, N].
LogComparison compare_with_robot_file(const RobotModel& model, const std::vector<LogInstant>& instants,
                                      const JointVector& noise);

/// Returns the kind as a word for files, such as "torques_exchanged".
const char* name(MistakeKind kind);

/// Returns one sentence that names the mistake, its joints and what to do.
std::string to_text(const LogMistake& mistake, const RobotModel& model);

}  // namespace armtune::internal
