#pragma once
// When a rollout need not go on: what it costs already is more than is of any use.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/metrics/metric.hpp"

namespace armtune {

struct EndCost {
  /// clamp(factor * (metric - from), 0, most); nothing while the metric has no finite value. Must be of a
  /// metric that only worsens, and grow with it.
  struct Share {
    Metric metric = Metric::kJointVelocityMaxRatio;
    double from = 0.0;  ///< in the metric's unit
    double factor = 1.0;
    double most = std::numeric_limits<double>::infinity();

    double at(double v) const { return !std::isfinite(v) ? 0.0 : std::clamp(factor * (v - from), 0.0, most); }
  };

  std::vector<Share> shares;
  /// The rollout ends in the first period in which the sum of the shares is above this.
  double beyond = std::numeric_limits<double>::infinity();
};

}  // namespace armtune
