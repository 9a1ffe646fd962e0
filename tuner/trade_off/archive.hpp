#pragma once
// The nondominated feasible points that a search for a Pareto front has found so far. Further searches start
// from them.

#include <vector>

#include "tuner/trade_off/pareto.hpp"

namespace armtune::internal {

class Archive {
 public:
  /// Adds the point if it is feasible, every cost has a value, and no other point dominates or equals it.
  /// Removes the points that it dominates.
  void add(ParetoPoint point);
  const std::vector<ParetoPoint>& points() const { return points_; }

  /// Returns the point with the least cost k among those at or below all `levels`, or null if there is none.
  /// The pointer is valid until the next call of `add`.
  const ParetoPoint* best_under(std::size_t k, const Costs& levels) const;

  /// Returns search coordinates where the search of a level begins. They belong to the point with the least
  /// first cost plus a penalty for exceeding the level, which is mostly the neighbour's point. start: its
  /// costs are the scale, and its coordinates are returned while there is no point.
  const std::vector<double>& beginning(const Costs& levels, const ParetoPoint& start) const;

 private:
  std::vector<ParetoPoint> points_;
};

}  // namespace armtune::internal
