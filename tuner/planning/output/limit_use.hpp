#pragma once
// How far a plan uses each of its limits, at its knots and between them. The program holds torque, tool path,
// gaze and distances at the knots; what they do between them is measured here.

#include <limits>

#include "tuner/planning/output/binding_limits.hpp"
#include "tuner/planning/output/plan_sample.hpp"

namespace armtune::internal {

struct LimitUse {
  std::string limit;  ///< "position", "velocity", "acceleration", "jerk", "torque", "tool path", "gaze",
                      ///< "distance to ..."
  std::string part;   ///< the joint or axis
  std::string unit;
  double lower = -std::numeric_limits<double>::infinity();  ///< in `unit`
  double upper = std::numeric_limits<double>::infinity();
  double from = 0.0;  ///< where it holds [s]
  double to = 0.0;
  double at_knots = 0.0;      ///< largest share of it that is used: 1 at the limit
  double between = 0.0;       ///< the same between the knots
  double between_time = 0.0;  ///< when [s]
  double share = 0.0;         ///< of the knots at which it holds the motion back
  double strength = 0.0;      ///< as BindingLimit has it; 0 where it does not
  std::vector<Stretch> stretches;
};

/// Every limit of the task; those that hold the plan back first, the strongest at the top.
std::vector<LimitUse> limit_uses(const PlanTask& task, const PlanProblem& problem,
                                 const PlannedTrajectory& planned);

/// The largest use of limits of one kind ("torque", "distance"), at any time; nothing where there is none.
struct WorstUse {
  const LimitUse* use = nullptr;  ///< null: there is no such limit
  double between = 0.0;
};
WorstUse worst_between(const std::vector<LimitUse>& uses, const std::string& kind);

}  // namespace armtune::internal
