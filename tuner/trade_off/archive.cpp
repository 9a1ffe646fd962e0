#include "tuner/trade_off/archive.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Weight of a relative excess over a level when the point where a search starts is chosen.
constexpr double kExcessWeight = 10.0;

}  // namespace

void Archive::add(ParetoPoint point) {
  const auto beats = [&point](const ParetoPoint& other) {
    return dominates(other.costs, point.costs) || other.costs == point.costs;
  };
  const bool whole =
      std::none_of(point.costs.begin(), point.costs.end(), [](double c) { return std::isnan(c); });
  if (!point.e.feasible || !whole || std::any_of(points_.begin(), points_.end(), beats)) return;
  std::erase_if(points_, [&point](const ParetoPoint& other) { return dominates(point.costs, other.costs); });
  points_.push_back(std::move(point));
}

const ParetoPoint* Archive::best_under(std::size_t k, const Costs& levels) const {
  const ParetoPoint* best = nullptr;
  for (const ParetoPoint& point : points_) {
    bool under = true;
    for (std::size_t c = 0; c < levels.size(); ++c) under = under && point.costs[c] <= levels[c];
    if (under && (best == nullptr || point.costs[k] < best->costs[k])) best = &point;
  }
  return best;
}

const std::vector<double>& Archive::beginning(const Costs& levels, const ParetoPoint& start) const {
  const std::vector<double>* best = &start.e.x;
  double least = HUGE_VAL;
  for (const ParetoPoint& point : points_) {
    double merit = point.costs[0] / std::abs(start.costs[0]);
    for (std::size_t c = 1; c < levels.size(); ++c) {
      merit += kExcessWeight * std::max(0.0, (point.costs[c] - levels[c]) / std::abs(start.costs[c]));
    }
    if (merit < least) {
      least = merit;
      best = &point.e.x;
    }
  }
  return *best;
}

}  // namespace armtune::internal
