#pragma once
// Stores the evaluations that a search has made in one dynamics engine, so that no point is simulated twice.
// It also keeps the best of them.

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "tuner/solver/solver.hpp"
#include "tuner/study/evaluation.hpp"
#include "tuner/study/objective.hpp"
#include "tuner/study/warm_start.hpp"

namespace armtune::internal {

class Seen {
 public:
  /// Number of best points that are kept.
  static constexpr std::size_t kBest = 3;

  /// The objective, relative to the start gains as this engine simulates them. The start gains themselves
  /// therefore score exactly 1.
  std::optional<Objective> objective;
  std::optional<Evaluation> start;  ///< evaluation of the start gains

  /// Adds an evaluation whose objective and constraints are computed. box: the bounds of the search, for
  /// best_inside().
  void take(const Evaluation& e, const WarmPoint& box);

  /// Returns the value at a point, or null if the point was not simulated.
  const SolverValue* at(const std::vector<double>& x) const {
    const auto found = values_.find(x);
    return found == values_.end() ? nullptr : &found->second;
  }
  /// Returns the best evaluations, the best first. Each point occurs once.
  const std::vector<Evaluation>& best() const { return best_; }
  /// Returns the best evaluation inside the bounds of the search, or nothing if there is none. A warm start
  /// may narrow these bounds.
  const std::optional<Evaluation>& best_inside() const { return best_inside_; }

 private:
  std::map<std::vector<double>, SolverValue> values_;
  std::vector<Evaluation> best_;
  std::optional<Evaluation> best_inside_;
};

}  // namespace armtune::internal
