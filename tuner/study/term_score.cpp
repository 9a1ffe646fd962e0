#include "tuner/study/term_score.hpp"

#include <algorithm>

namespace armtune::internal {

namespace {

constexpr double kMiddle = kLargestRatio / 2.0;

}  // namespace

double term_score(Metric metric, double value, double reference) {
  const double r = value / reference;
  if (!larger_is_better(metric)) return std::min(r, kLargestRatio);
  return r >= 1.0 / kMiddle ? 1.0 / r : kLargestRatio - 1.0 / (2.0 / kMiddle - r);
}

double term_slope(Metric metric, double value, double reference) {
  const double r = value / reference;
  if (!larger_is_better(metric)) return r < kLargestRatio ? 1.0 / reference : 0.0;
  const double s = r >= 1.0 / kMiddle ? r : 2.0 / kMiddle - r;
  return -1.0 / (s * s * reference);
}

}  // namespace armtune::internal
