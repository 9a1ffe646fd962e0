#pragma once
// Explains why no motion was found: which limit prevents it, at what time, and by how much the planned motion
// would violate this limit.

#include <string>

#include "tuner/planning/transcription/refining_solver.hpp"

namespace armtune::internal {

/// The row (limit or equation of the task) that is violated most, in proportion to its limit.
struct WorstViolation {
  RowMeaning meaning;
  double time = 0.0;       ///< [s]
  double violation = 0.0;  ///< relative to the limit; for an equation in the equation's unit
  double value = 0.0;      ///< value and bound are in the unit of `meaning`
  double bound = 0.0;
  bool equation = false;
};
/// Returns the largest violation of a plan that was not solved.
WorstViolation worst_violation(const PlannedTrajectory& planned);

/// Returns a sentence such as "torque of wrist_2_joint would be 31.2 N m at 0.31 s; its limit is 28 N m".
std::string sentence(const WorstViolation& worst);

}  // namespace armtune::internal
