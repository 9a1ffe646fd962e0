#pragma once
// Reasons to doubt an identified theta, from what it leaves unexplained and from its masses.

#include <string>
#include <vector>

#include "tuner/identification/identify.hpp"

namespace armtune::internal {

/// Returns one sentence, with joint or link and values, for each of these:
///   - a joint of whose torque over half is unexplained, on the rows fitted to or on those held out;
///   - a joint of which the identified theta leaves clearly more than the robot file does;
///   - a link over three times as heavy as in the robot file, by over half of the arm's moved mass;
///   - an arm whose moved mass is 1.8 times the robot file's or more, or the robot file's that many times it.
/// The noise of the torque sensors does not count, nor do torques below half a percent of the effort limit.
std::vector<std::string> theta_doubts(const RobotModel& model, const Identification& found);

}  // namespace armtune::internal
