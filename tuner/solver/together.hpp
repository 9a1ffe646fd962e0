#pragma once
// Runs several searches at the same time, in rounds. In each round, every search requests points. The points
// of all searches are then evaluated together, so that the simulations can run in parallel.

#include <functional>
#include <vector>

#include "tuner/solver/solver.hpp"

namespace armtune::internal {

struct JoinedSearch {
  SolverProblem problem;  ///< its `evaluate` is not used
  SolverOptions options;
};

/// The points that one search requests in a round, and their values.
struct Request {
  std::size_t search = 0;  ///< index of the search
  std::vector<SolverPoint> points;
  std::vector<SolverValue> values;  ///< filled by `evaluate`, in the way of SolverProblem::evaluate
  bool go_on = true;                ///< set to false to end this search at once
};

/// Runs every search in a separate thread. A round begins when every search that has not ended has made a
/// request. Then `evaluate` is called in the caller's thread with all requests, in the order of the searches.
/// Thus the result does not depend on how threads are scheduled. If a search or `evaluate` throws, all
/// searches end, and the exception is thrown again here. If several searches throw in one round, the
/// exception of the first of them is thrown.
std::vector<SolverOutcome> minimize_together(const std::vector<JoinedSearch>& searches,
                                             const std::function<void(std::vector<Request>&)>& evaluate);

}  // namespace armtune::internal
