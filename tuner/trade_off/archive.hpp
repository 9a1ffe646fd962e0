#pragma once
// The best a search for a front has seen: feasible points that no other dominates, and where to begin next.

#include <vector>

#include "tuner/trade_off/pareto.hpp"

namespace armtune::internal {

class Archive {
 public:
  /// Takes the point in if it is feasible, every cost has a value and none dominates or equals it; what it
  /// dominates goes.
  void add(ParetoPoint point);
  const std::vector<ParetoPoint>& points() const { return points_; }

  /// The point with the least cost k of those at or under all `levels`, or null. Good until the next `add`.
  const ParetoPoint* best_under(std::size_t k, const Costs& levels) const;

  /// Search coordinates to begin a level's search at: of the point that is best in the first cost once what
  /// it exceeds the level by is paid for, mostly the neighbour's. `start`: whose costs are the scale, and
  /// where to begin while there is no point.
  const std::vector<double>& beginning(const Costs& levels, const ParetoPoint& start) const;

 private:
  std::vector<ParetoPoint> points_;
};

}  // namespace armtune::internal
