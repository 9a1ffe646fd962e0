#pragma once
// Helper functions for the constraints and costs (terms) of arm_terms.hpp. They set up a term's knots, rows
// and units.

#include "tuner/planning/transcription/arm_terms.hpp"

namespace armtune::internal {

/// Returns a term that applies at these knots, with one row for each name in `rows`.
KnotTerm over(KnotRange knots, const std::string& name, const std::vector<std::string>& rows);

/// Returns one unit for each joint: `turning` for a revolute joint, `sliding` for a prismatic one.
std::vector<std::string> units_by_motion(const RobotModel& robot, const char* turning, const char* sliding);

/// Declares that the rows' values are lengths [m] multiplied by `factor`. They are then shown in meters.
void in_meters(double factor, KnotTerm& term);

}  // namespace armtune::internal
