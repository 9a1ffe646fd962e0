#pragma once
// Compares a robot file with a log in all ways that the log allows: its torques, its motion and the log
// itself.

#include <optional>
#include <string>
#include <vector>

#include "tuner/validation/log_joints.hpp"
#include "tuner/validation/motion_validation.hpp"
#include "tuner/validation/torque_validation.hpp"

namespace armtune::internal {

struct LogValidation {
  ValidationThresholds thresholds;
  std::optional<TorqueValidation> torques;  ///< none: the log has no torques
  std::optional<MotionValidation> motion;   ///< none: the log has no commands, or none that can be simulated
  std::vector<LogFinding> findings;         ///< about the log itself; empty: it is plausible
  std::vector<std::string> not_compared;    ///< sentences without full stop

  /// True if everything that was compared matches. A log without torques and commands matches if nothing is
  /// wrong with the log itself.
  bool matches() const;
  /// True if everything that was compared for the joint matches.
  bool matches(int joint) const;
};

/// Compares the unfitted model with the log. Throws InputError if the log is malformed or too short. Commands
/// that cannot be simulated are listed in `not_compared`.
LogValidation validate_log(const RobotModel& model, const LoggedJoints& logged,
                           const ValidationThresholds& thresholds = {});

/// Returns the verdict as one sentence without full stop.
std::string headline(const LogValidation& found, const RobotModel& model);

/// Returns one sentence for each joint whose torque does not match, or has a likely cause of a misfit, and
/// the sentences about the motion.
std::vector<std::string> cause_sentences(const LogValidation& found, const RobotModel& model);

/// Returns one sentence for each finding about the log.
std::vector<std::string> finding_sentences(const LogValidation& found, const RobotModel& model);

}  // namespace armtune::internal
