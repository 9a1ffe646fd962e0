#pragma once
// Generates the text of the files that a calibration leaves.

#include "tuner/calibration/calibrate.hpp"

namespace armtune::internal {

/// What has to be said with the intervals of a calibration from position commands, as a sentence without full
/// stop.
inline constexpr const char* kNarrowIntervals =
    "the 95 % intervals are too narrow for position commands: with simulated arms, only about two thirds of "
    "them held the true value";

/// Returns the model with the friction, rotor inertia, drive gains and payload of a calibration. The payload
/// is part of the last link. Delay, tilt of the base and encoder offsets are not part of a robot model. Marks
/// of the robot file, such as `published`, stay only where no value was fitted.
RobotModel calibrated_model(const RobotModel& model, const Calibration& found);

/// Returns the text of robot.yaml. urdf: name of the file with the text urdf_text(calibrated_model(...)).
/// What a robot file cannot contain is given in comments.
std::string calibrated_robot_yaml(const RobotModel& model, const Calibration& found, const std::string& urdf);

/// Returns the text of uncertainty.yaml: the joint normal distribution of the fitted parameters, and which of
/// them the log does not tell. For a positive parameter, the distribution is that of its logarithm. The
/// covariance holds the rows of the lower triangle. Numbers read back to the same bits. `robot_file` is the
/// value in robot.yaml. load_arm_distribution (sim/scenario/arm_distribution.hpp) reads the text.
std::string uncertainty_yaml(const Calibration& found);

}  // namespace armtune::internal
