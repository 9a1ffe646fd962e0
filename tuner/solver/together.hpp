#pragma once
// Several searches at once, in lock step: what all of them ask for is evaluated as one batch.

#include <functional>
#include <vector>

#include "tuner/solver/solver.hpp"

namespace armtune::internal {

struct JoinedSearch {
  SolverProblem problem;  ///< its `evaluate` is not used
  SolverOptions options;
};

/// What one search asks for in a round, and what it is told.
struct Request {
  std::size_t search = 0;  ///< index
  std::vector<SolverPoint> points;
  std::vector<SolverValue> values;  ///< as SolverProblem::evaluate fills them
  bool go_on = true;                ///< false: ends this search at once
};

/// Runs every search in a thread of its own. Each round waits until every search that has not ended asks,
/// then calls `evaluate` in the caller's thread with all requests, in the order of the searches: the rounds
/// do not depend on how threads are scheduled. An exception, of a search or of `evaluate`, ends all searches
/// and is thrown again here; of several in one round, that of the first search.
std::vector<SolverOutcome> minimize_together(const std::vector<JoinedSearch>& searches,
                                             const std::function<void(std::vector<Request>&)>& evaluate);

}  // namespace armtune::internal
