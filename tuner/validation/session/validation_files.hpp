#pragma once
// Generates the text of the files that `armtune validate` writes, and the facts for its record.

#include <string>

#include "tuner/run/run_facts.hpp"
#include "tuner/validation/log_validation.hpp"

namespace armtune::internal {

/// Returns the text of residuals.csv: `time`, and for each joint `joint/NAME/measured`,
/// `joint/NAME/predicted` and `joint/NAME/residual` [N m, N], filtered as docs/validation.md says.
std::string residuals_csv(const RobotModel& model, const TorqueRows& rows);

/// Returns the text of horizons.csv: `horizon` [s], `windows`, and for each joint `joint/NAME/rms`,
/// `joint/NAME/low`, `joint/NAME/high` and `joint/NAME/yardstick` [rad, m]. A value that is not known is an
/// empty cell.
std::string horizons_csv(const RobotModel& model, const MotionValidation& motion);

/// Returns what run.json says about the validation.
ValidationFacts validation_facts(const RobotModel& model, const LoggedJoints& logged,
                                 const LogValidation& found);

}  // namespace armtune::internal
