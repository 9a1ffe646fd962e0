#pragma once
// Checks a log itself before its torques are compared with the model: are the positions, velocities and
// torques what they are said to be? Each finding has a kind and numbers. Signs, order, zero positions and
// mounting of the joints are found as in identification (log_mistakes.hpp), whose findings are passed on.

#include <optional>
#include <string>
#include <vector>

#include "tuner/identification/log_mistakes.hpp"
#include "tuner/validation/misfit_cause.hpp"

namespace armtune::internal {

enum class LogFindingKind {
  kRate,            ///< value: true over stated duration of all samples, from all velocities
  kVelocityScale,   ///< value: measured over differentiated velocity
  kVelocitySign,    ///< the measured velocity has the other sign
  kVelocityOrder,   ///< the measured velocity of `joint` is that of joint `other`
  kVelocityOther,   ///< the measured velocity is not the derivative of any position; value: correlation
  kVelocityOffset,  ///< value: time by which the measured velocities are late [s]
  kTorqueOffset,    ///< value: time by which the torques are late [s]
  kTorqueFiltered,  ///< value: time constant of the low-pass filter that the torques have passed [s]
  kTorqueClipped,   ///< value: the torque at which many samples stay [N m, N]; share: of the samples
  kTorqueFrozen,    ///< value: longest time without a change during motion [s]; time: its begin
  kVelocityFrozen,  ///< likewise
  kPositionFrozen,  ///< likewise, although the measured velocity is not zero
  kJump,            ///< value: size of a jump of the position [rad, m]; time: when
  kPositionUnit,    ///< value: largest position as a multiple of the limit, which suggests degrees
  kTilt,            ///< value: angle between fitted and stated gravity [rad]; direction: fitted gravity
  kMistake,         ///< one of log_mistakes.hpp
};

/// Returns the kind as a word for files, such as "torque_filtered".
const char* name(LogFindingKind kind);

struct LogFinding {
  LogFindingKind kind = LogFindingKind::kMistake;
  int joint = -1;  ///< -1: all
  int other = -1;
  double value = 0.0;
  double share = 0.0;
  double time = 0.0;
  Vec3 direction = Vec3::Zero();
  std::optional<LogMistake> mistake = {};
};

/// Returns the kind as a word for files; of one of log_mistakes.hpp, the name of the mistake.
const char* kind_of(const LogFinding& finding);

/// Returns what is wrong with a log; empty if nothing is. Takes up to some seconds if signs and order have to
/// be searched. motion, rows, misfit: computed from the same log and model.
std::vector<LogFinding> log_findings(const RobotModel& model, const JointLog& log, const LoggedMotion& motion,
                                     const TorqueRows& rows, const Misfit& misfit,
                                     const ValidationThresholds& thresholds = {});

/// Returns what is wrong with the positions and velocities of a log, whether it has torques or not.
std::vector<LogFinding> motion_findings(const RobotModel& model, const JointLog& log,
                                        const LoggedMotion& motion,
                                        const ValidationThresholds& thresholds = {});

/// Returns one sentence without a full stop: what is wrong, where, and what to do.
std::string to_text(const LogFinding& finding, const RobotModel& model);

}  // namespace armtune::internal
