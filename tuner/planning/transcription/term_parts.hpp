#pragma once
// Helper functions for the constraints and costs (terms) of arm_terms.hpp. They set up a term's knots, rows
// and units.

#include "tuner/planning/transcription/arm_terms.hpp"

namespace armtune::internal {

/// Returns a term over these knots with one row for each name.
KnotTerm over(KnotRange knots, const std::string& name, const std::vector<std::string>& rows);

/// Returns one unit for each joint, by whether it turns or slides.
std::vector<std::string> units_by_motion(const RobotModel& robot, const char* turning, const char* sliding);

/// Marks the rows' values as lengths [m] times `factor`.
void in_meters(double factor, KnotTerm& term);

}  // namespace armtune::internal
