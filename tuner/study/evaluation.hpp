#pragma once
// What a candidate turned out to be worth, and the one ordering of candidates.

#include <cmath>
#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/rollout/rollout.hpp"

namespace armtune::internal {

struct Evaluation {
  std::vector<double> x;  ///< search coordinates
  Gains gains;
  double objective = 0.0;           ///< finite; the start scores 1
  std::vector<double> constraints;  ///< g <= 0 holds, in natural units
  std::vector<double> relative;     ///< the same over their limits, for the search
  double violation = 0.0;           ///< sum of relative violations; 0 if feasible, larger than that of any
                                    ///< completed candidate if a scenario did not complete
  bool feasible = false;
  std::string status;                  ///< "completed", or what went wrong first
  std::vector<RolloutResult> results;  ///< one per scenario
  Engine engine = Engine::kSimbody;    ///< that gave the results
  double seconds = 0.0;                ///< wall time of the run when it was finished
  bool recalled = false;               ///< from the journal of a run that is resumed
};

/// As a search with penalties sees it: objective + penalty * sum of its positive relative violations.
inline double penalised(const Evaluation& e, double penalty) {
  double sum = e.objective;
  for (const double g : e.relative) {
    if (g > 0.0) sum += penalty * g;
  }
  return sum;
}

/// Feasible before infeasible; among feasible the smaller objective; among infeasible the smaller violation,
/// then the smaller objective.
inline bool better(const Evaluation& a, const Evaluation& b) {
  if (a.feasible != b.feasible) return a.feasible;
  if (!a.feasible && a.violation != b.violation) return a.violation < b.violation;
  return a.objective < b.objective;
}

}  // namespace armtune::internal
