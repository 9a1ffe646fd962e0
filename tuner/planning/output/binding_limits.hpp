#pragma once
// Which limits a planned motion runs into, and, where there is none, what is in the way.

#include "tuner/planning/transcription/refining_solver.hpp"

namespace armtune::internal {

/// A limit is active from its first to its last knot without a gap [s].
struct Stretch {
  double from = 0.0;
  double to = 0.0;
  bool upper = true;  ///< which of its two bounds
};

/// A limit of one joint or axis that holds the motion back.
struct BindingLimit {
  std::string limit;   ///< "velocity", "torque", "gaze"...
  std::string part;    ///< the joint or axis
  double share = 0.0;  ///< of the knots at which it is active
  double first = 0.0;  ///< s, of the first and the last of them
  double last = 0.0;
  double value = 0.0;              ///< the one farthest beyond the limit, or at it
  double bound = 0.0;              ///< the limit there
  std::string unit;                ///< of both
  double strength = 0.0;           ///< sum of its multipliers: seconds, or cost, per unit of relief
  std::vector<Stretch> stretches;  ///< in order of time
};

/// The limits that are active, the strongest first. What a task asks for (start, goal, path) is none.
std::vector<BindingLimit> binding_limits(const PlannedTrajectory& planned);

}  // namespace armtune::internal
