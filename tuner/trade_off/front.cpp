#include "tuner/trade_off/front.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Returns the volume of the union of all boxes between the origin and a point of `gains`, in the first
/// `dimensions` coordinates. A gain is the distance of a cost below the reference, and is positive.
double volume(std::vector<Costs> gains, std::size_t dimensions) {
  if (gains.empty()) return 0.0;
  const std::size_t last = dimensions - 1;
  std::sort(gains.begin(), gains.end(), [last](const Costs& a, const Costs& b) { return a[last] > b[last]; });
  if (dimensions == 1) return gains.front()[0];
  double sum = 0.0;
  for (std::size_t i = 0; i < gains.size(); ++i) {
    const double next = i + 1 < gains.size() ? gains[i + 1][last] : 0.0;
    const double height = gains[i][last] - next;
    if (height <= 0.0) continue;
    // The points whose last gain is at least this large.
    const auto end = gains.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    sum += height * volume({gains.begin(), end}, last);
  }
  return sum;
}

}  // namespace

bool dominates(const Costs& a, const Costs& b) {
  bool better = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!(a[k] <= b[k])) return false;
    better = better || a[k] < b[k];
  }
  return better;
}

std::vector<std::size_t> non_dominated(const std::vector<Costs>& points) {
  std::vector<std::size_t> order;
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool whole =
        std::none_of(points[i].begin(), points[i].end(), [](double c) { return std::isnan(c); });
    if (whole) order.push_back(i);
  }
  // In this order, a point comes after all points that dominate it.
  std::stable_sort(order.begin(), order.end(),
                   [&points](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    const bool beaten = std::any_of(front.begin(), front.end(), [&](std::size_t f) {
      return dominates(points[f], points[i]) || points[f] == points[i];
    });
    if (!beaten) front.push_back(i);
  }
  return front;
}

double hypervolume(const std::vector<Costs>& points, const Costs& reference) {
  std::vector<Costs> gains;
  for (const Costs& point : points) {
    Costs gain(reference.size());
    bool inside = true;
    for (std::size_t k = 0; k < reference.size(); ++k) {
      gain[k] = (reference[k] - point[k]) / std::abs(reference[k]);
      inside = inside && gain[k] > 0.0;
    }
    if (inside) gains.push_back(std::move(gain));
  }
  return volume(std::move(gains), reference.size());
}

}  // namespace armtune::internal
