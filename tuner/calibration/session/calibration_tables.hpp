#pragma once
// Generates the tables that `armtune calibrate` writes, and the facts for its record.

#include <string>

#include "tuner/calibration/calibration_summary.hpp"
#include "tuner/run/calibration_facts.hpp"

namespace armtune::internal {

/// Returns the text of parameters.csv, a row for each fitted parameter: `parameter`, `unit`, `before` (robot
/// file), `after` (most probable value), `low` and `high` (95 % interval), `spread` (standard deviation
/// after the fit, relative to the prior's), `told` (1: the log tells it), `kept` (1: the calibrated arm keeps
/// the value of the robot file), `needs` and `motion` (what would tell it: name, and in words).
std::string parameters_csv(const RobotModel& model, const Calibration& found);

/// Returns the text of held_out.csv: `horizon` [s], `windows`, and for each joint `joint/NAME/before` and
/// `joint/NAME/after`, the RMS errors of the robot file and of the calibrated arm [rad, m].
std::string held_out_csv(const RobotModel& model, const Calibration& found);

/// Returns what run.json says about the calibration, except how the logs were read.
CalibrationFacts calibration_facts(const RobotModel& model, const Calibration& found);

/// Returns the unit of a parameter: of those for joints that turn or slide, the one for its joint.
std::string unit_of(const RobotModel& model, const CalibrationParameter& parameter);

}  // namespace armtune::internal
