// Computes the result of a Pareto search from its points.

#include <algorithm>

#include "tuner/trade_off/pareto.hpp"

namespace armtune::internal {

std::size_t ParetoOptions::searches() const {
  std::size_t count = 2;
  for (std::size_t k = 1; k < criteria.size(); ++k) count *= levels;
  return count;
}

std::size_t ParetoResult::dominating_start() const {
  return static_cast<std::size_t>(std::count_if(
      front.begin(), front.end(), [this](const ParetoPoint& p) { return dominates(p.costs, start.costs); }));
}

void settle(ParetoResult& result, const std::vector<ParetoPoint>& points) {
  std::vector<Costs> costs;
  costs.reserve(points.size());
  for (const ParetoPoint& point : points) costs.push_back(point.costs);
  std::vector<ParetoPoint> front;
  for (const std::size_t i : non_dominated(costs)) front.push_back(points[i]);
  result.front = std::move(front);
  result.hypervolume = result.front.empty() ? 0.0 : hypervolume(costs, result.start.costs);
  for (auto level = result.levels.begin(); level != result.levels.end();) {
    // The front ascends in the first cost, so the first point within the limits is the best.
    const auto best = std::find_if(result.front.begin(), result.front.end(), [&level](const ParetoPoint& p) {
      for (std::size_t c = 0; c < p.costs.size(); ++c) {
        if (p.costs[c] > level->levels[c]) return false;
      }
      return true;
    });
    level->best = static_cast<std::size_t>(best - result.front.begin());
    level = best == result.front.end() ? result.levels.erase(level) : level + 1;
  }
}

}  // namespace armtune::internal
