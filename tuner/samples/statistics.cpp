#include "tuner/samples/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Quantile of the standard normal distribution for a two-sided 95 % interval.
constexpr double kNormal95 = 1.959963984540054;

}  // namespace

double quantile(std::span<const double> sorted, double p) {
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  const double part = place - static_cast<double>(below);
  return part > 0.0 ? sorted[below] + part * (sorted[above] - sorted[below]) : sorted[below];
}

double conditional_value_at_risk(std::span<const double> sorted, double p) {
  double weight = (1.0 - p) * static_cast<double>(sorted.size());
  const double whole = weight;
  double sum = 0.0;
  for (std::size_t i = sorted.size(); i > 0 && weight > 0.0; --i) {
    sum += std::min(1.0, weight) * sorted[i - 1];
    weight -= 1.0;
  }
  return sum / whole;
}

std::pair<double, double> wilson_interval(std::size_t successes, std::size_t trials) {
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double z2 = kNormal95 * kNormal95;
  const double center = (p + 0.5 * z2 / n) / (1.0 + z2 / n);
  const double half = kNormal95 / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + 0.25 * z2 / (n * n));
  // If no trial or every trial succeeded, that end is exactly 0 or 1, without the rounding of the root.
  return {successes == 0 ? 0.0 : center - half, successes == trials ? 1.0 : center + half};
}

}  // namespace armtune::internal
