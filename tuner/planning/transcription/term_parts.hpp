#pragma once
// What the terms of arm_terms.hpp begin with: their knots, their rows, their units.

#include "tuner/planning/transcription/arm_terms.hpp"

namespace armtune::internal {

/// A term over these knots, a row for each name.
KnotTerm over(KnotRange knots, const std::string& name, const std::vector<std::string>& rows);

/// A unit for each joint.
std::vector<std::string> units_by_motion(const RobotModel& robot, const char* turning, const char* sliding);

/// The rows' values are lengths [m] times `factor`.
void in_meters(double factor, KnotTerm& term);

}  // namespace armtune::internal
