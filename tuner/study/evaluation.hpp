#pragma once
// The evaluation of one candidate gain set: its objective, its constraints and its simulation results. Every
// search compares two candidates with the function better().

#include <cmath>
#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/rollout/rollout.hpp"

namespace armtune::internal {

struct Evaluation {
  std::vector<double> x;  ///< search coordinates
  Gains gains;
  double objective = 0.0;           ///< finite; 1 for the start gains, smaller values are better
  std::vector<double> constraints;  ///< violations in units of the metrics; zero or less: satisfied
  std::vector<double> relative;     ///< the same violations relative to the limits, for the search
  double violation = 0.0;           ///< sum of the positive relative violations; 0 if feasible; if a scenario
                                    ///< did not complete, larger than for any candidate that completed all
  bool feasible = false;
  bool completed = false;              ///< true if every scenario completed (corners are not counted)
  std::string reason;                  ///< why the first failed scenario ended; empty if all completed
  std::vector<RolloutResult> results;  ///< one per simulated scenario, corners (corner.hpp) included
  Engine engine = Engine::kSimbody;    ///< engine that computed the results
  double seconds = 0.0;                ///< wall time of the run when the evaluation was finished [s]
  bool recalled = false;               ///< true if it comes from the journal of a resumed run
  long copies = 0;  ///< perturbed copies that the run had simulated for derivatives by then
};

/// Returns the value that a search with penalties minimises: the objective plus `penalty` times the sum of
/// the positive relative violations.
inline double penalised(const Evaluation& e, double penalty) {
  double sum = e.objective;
  for (const double g : e.relative) {
    if (g > 0.0) sum += penalty * g;
  }
  return sum;
}

/// True if a is better than b. A feasible candidate is better than an infeasible one. Of two feasible ones,
/// the one with the smaller objective is better. Of two infeasible ones, the one with the smaller violation
/// is better; if the violations are equal, the objective decides.
inline bool better(const Evaluation& a, const Evaluation& b) {
  if (a.feasible != b.feasible) return a.feasible;
  if (!a.feasible && a.violation != b.violation) return a.violation < b.violation;
  return a.objective < b.objective;
}

}  // namespace armtune::internal
