#pragma once
// What a run has seen in one engine.

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
  /// Points kept of the best.
  static constexpr std::size_t kBest = 3;

  /// Relative to the start as this engine simulates it: what equals the start does so to the bit.
  std::optional<Objective> objective;
  std::optional<Evaluation> start;

  /// box: see best_inside().
  void take(const Evaluation& e, const WarmPoint& box);

  /// Returns the value at a point simulated before; null if it was not.
  const SolverValue* at(const std::vector<double>& x) const {
    const auto found = values_.find(x);
    return found == values_.end() ? nullptr : &found->second;
  }
  /// First the best; a point once.
  const std::vector<Evaluation>& best() const { return best_; }
  /// Of those that the search may reach.
  const std::optional<Evaluation>& best_inside() const { return best_inside_; }

 private:
  std::map<std::vector<double>, SolverValue> values_;
  std::vector<Evaluation> best_;
  std::optional<Evaluation> best_inside_;
};

}  // namespace armtune::internal
