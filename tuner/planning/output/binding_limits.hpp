#pragma once
// Finds the active limits of a planned motion, that is, the limits that prevent a faster or more accurate
// motion. If the planner found no motion, finds the limits that prevent a solution.

#include "tuner/planning/transcription/refining_solver.hpp"

namespace armtune::internal {

/// A period in which a limit is active at every knot (point of the time grid). It lasts from the first to the
/// last of these knots [s].
struct Stretch {
  double from = 0.0;
  double to = 0.0;
  bool upper = true;  ///< true if the upper bound is active, else the lower one
};

/// An active limit of one joint or axis.
struct BindingLimit {
  std::string limit;   ///< kind of limit: "velocity", "torque", "gaze"...
  std::string part;    ///< the joint or axis
  double share = 0.0;  ///< share of the knots at which the limit is active
  double first = 0.0;  ///< times of the first and the last of these knots [s]
  double last = 0.0;
  double value = 0.0;              ///< value that exceeds the limit most, or that is nearest to the limit
  double bound = 0.0;              ///< the limit, at the knot of this value
  std::string unit;                ///< unit of value and bound
  double strength = 0.0;           ///< sum of its multipliers: seconds or cost saved per unit of relaxation
  std::vector<Stretch> stretches;  ///< in order of time
};

/// Returns the active limits, the strongest first. Equations of the task, such as its start, its goal, or a
/// path without tolerance, are not limits. Limits with less than 1e-4 of the greatest strength are left out.
std::vector<BindingLimit> binding_limits(const PlannedTrajectory& planned);

}  // namespace armtune::internal
