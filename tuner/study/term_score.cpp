#include "tuner/study/term_score.hpp"

#include <algorithm>

namespace armtune::internal {

double term_score(Metric metric, double value, double reference) {
  constexpr double kMiddle = kLargestRatio / 2.0;
  const double r = value / reference;
  if (!larger_is_better(metric)) return std::min(r, kLargestRatio);
  return r >= 1.0 / kMiddle ? 1.0 / r : kLargestRatio - 1.0 / (2.0 / kMiddle - r);
}

}  // namespace armtune::internal
