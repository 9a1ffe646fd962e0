#pragma once
// Checks the samples of single channels: clipped torques, channels that keep one value while the joint moves,
// jumps, positions far beyond their limits; and velocities against the derivatives of the positions.

#include <vector>

#include "tuner/validation/log_checks.hpp"

namespace armtune::internal {

/// Returns findings about the samples as they were logged.
std::vector<LogFinding> channel_findings(const RobotModel& model, const JointLog& log,
                                         const LoggedMotion& motion, const ValidationThresholds& thresholds);

/// Returns findings about the measured velocities: wrong rate of the log, scale, sign, order, time offset.
std::vector<LogFinding> velocity_findings(const LoggedMotion& motion, const ValidationThresholds& thresholds);

}  // namespace armtune::internal
