#pragma once
// Finds reasons to doubt an identified theta (inertial and friction parameters): torques that it leaves
// unexplained, and masses far from those of the robot file.

#include <string>
#include <vector>

#include "tuner/identification/identify.hpp"

namespace armtune::internal {

/// Returns one sentence, with joint or link and values, for each of these:
///   - a joint with over half of its torque unexplained, on the fitted rows or on the held-out rows;
///   - a joint for which the identified theta leaves clearly more unexplained than the robot file does;
///   - a joint whose logged torque is at most 5 % of the torque that the robot file predicts;
///   - a log in which the robot file leaves at least half of every joint's torque unexplained, and the
///     identified theta still leaves at least a tenth of some joint's torque unexplained;
///   - a link over three times as heavy as in the robot file, if the difference is over half of the arm's
///     moved mass;
///   - an arm whose moved mass differs from that of the robot file by a factor of more than 1.8.
/// Noise of the torque sensors does not count as unexplained torque, nor do torques below half a percent of
/// the effort limit.
std::vector<std::string> theta_doubts(const RobotModel& model, const Identification& found);

}  // namespace armtune::internal
