#pragma once
// Stores the points that a search for a Pareto front keeps: all feasible points found so far that no other
// one dominates (front.hpp). Further searches start from these points.

#include <vector>

#include "tuner/trade_off/pareto.hpp"

namespace armtune::internal {

class Archive {
 public:
  /// Adds the point if it is feasible, no cost is NaN, and no point of the archive dominates it or has equal
  /// costs. Then removes the points that the new one dominates.
  void add(ParetoPoint point);
  const std::vector<ParetoPoint>& points() const { return points_; }

  /// Returns the point with the smallest cost k among the points whose costs are all at or below `levels`, or
  /// null if there is none. The pointer is valid until the next call of `add`.
  const ParetoPoint* best_under(std::size_t k, const Costs& levels) const;

  /// Returns the search coordinates at which the search for these levels starts. They belong to the point
  /// with the smallest sum of the first cost and a penalty for costs above the levels. Usually, this point
  /// was found for a neighbouring level. start: the start gains; all costs are divided by the costs of these
  /// gains. If the archive is empty, the coordinates of `start` are returned.
  const std::vector<double>& beginning(const Costs& levels, const ParetoPoint& start) const;

 private:
  std::vector<ParetoPoint> points_;
};

}  // namespace armtune::internal
