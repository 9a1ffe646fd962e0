#pragma once
// Measures how much of each limit a planned motion uses, at its knots (points of the time grid) and between
// them. The planner enforces the limits of torque, tool path, gaze and distances at the knots only. The
// motion may exceed these limits between knots, so this must be measured.

#include <limits>
#include <vector>

#include "tuner/planning/output/binding_limits.hpp"
#include "tuner/planning/output/plan_sample.hpp"

namespace armtune::internal {

/// The use of one limit of one joint or axis.
struct LimitUse {
  LimitKind kind = LimitKind::kPosition;
  std::string limit;  ///< its name, such as "torque"; for a distance with the object, "distance to the floor"
  std::string part;   ///< the joint or axis
  std::string unit;
  double lower = -std::numeric_limits<double>::infinity();  ///< in `unit`
  double upper = std::numeric_limits<double>::infinity();
  double from = 0.0;  ///< start and end of the time in which the limit applies [s]
  double to = 0.0;
  double at_knots = 0.0;           ///< largest share of the limit that is used at a knot: 1 at the limit
  double between = 0.0;            ///< largest share that is used between knots
  double between_time = 0.0;       ///< time of this largest share between knots [s]
  double share = 0.0;              ///< share of the knots at which the limit is active
  double strength = 0.0;           ///< as in BindingLimit; 0 if binding_limits() does not return this limit
  std::vector<Stretch> stretches;  ///< periods in which the limit is active
};

/// Returns the use of every limit of the task. Active limits come first, the strongest at the top.
std::vector<LimitUse> limit_uses(const PlanTask& task, const PlanProblem& problem,
                                 const PlannedTrajectory& planned);

/// The limit that is used most between knots, among the limits of the given kinds.
struct WorstUse {
  const LimitUse* use = nullptr;  ///< one of the uses that were given; null: no limit of these kinds
  double between = 0.0;
};
WorstUse worst_between(const std::vector<LimitUse>& uses, const std::vector<LimitKind>& kinds);

}  // namespace armtune::internal
