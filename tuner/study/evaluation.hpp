#pragma once
// The evaluation of one candidate gain set: its objective, its constraints and its simulation results. Also
// the order of candidates, by which every search decides which one is better.

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
  std::vector<double> constraints;  ///< satisfied if <= 0; in natural units
  std::vector<double> relative;     ///< the same relative to their limits, for the search
  double violation = 0.0;           ///< sum of relative violations; 0 if feasible, larger than that of any
                                    ///< completed candidate if a scenario did not complete
  bool feasible = false;
  std::string status;                  ///< "completed", or what went wrong first
  std::vector<RolloutResult> results;  ///< one per scenario
  Engine engine = Engine::kSimbody;    ///< engine that gave the results
  double seconds = 0.0;                ///< wall time of the run when it was finished
  bool recalled = false;               ///< true if it comes from the journal of a resumed run
};

/// Returns the value that a search with penalties uses: objective + penalty * sum of the positive relative
/// violations.
inline double penalised(const Evaluation& e, double penalty) {
  double sum = e.objective;
  for (const double g : e.relative) {
    if (g > 0.0) sum += penalty * g;
  }
  return sum;
}

/// True if a is better than b. Feasible comes before infeasible. Among feasible ones the smaller objective is
/// better; among infeasible ones the smaller violation, then the smaller objective.
inline bool better(const Evaluation& a, const Evaluation& b) {
  if (a.feasible != b.feasible) return a.feasible;
  if (!a.feasible && a.violation != b.violation) return a.violation < b.violation;
  return a.objective < b.objective;
}

}  // namespace armtune::internal
