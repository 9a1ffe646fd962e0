#pragma once
// Runs several searches at once, in lock step. The points that all of them request are evaluated in one
// batch.

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
  std::size_t search = 0;  ///< index
  std::vector<SolverPoint> points;
  std::vector<SolverValue> values;  ///< as SolverProblem::evaluate fills them
  bool go_on = true;                ///< false: ends this search at once
};

/// Runs every search in a thread of its own. Each round waits until every search that has not ended has made
/// a request. It then calls `evaluate` in the caller's thread with all requests, in the order of the
/// searches, so that the rounds do not depend on how threads are scheduled. An exception, of a search or of
/// `evaluate`, ends all searches and is thrown again here. Of several in one round it is that of the first
/// search.
std::vector<SolverOutcome> minimize_together(const std::vector<JoinedSearch>& searches,
                                             const std::function<void(std::vector<Request>&)>& evaluate);

}  // namespace armtune::internal
