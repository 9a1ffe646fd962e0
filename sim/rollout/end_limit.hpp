#pragma once
// When a rollout need not go on: a metric that cannot recover has passed a value of no use any more.

#include <vector>

#include "sim/metrics/metric.hpp"

namespace armtune::internal {

/// A rollout ends in the first period in which the metric, one that only worsens, is at `value` or worse.
struct EndLimit {
  Metric metric = Metric::kJointVelocityMaxRatio;
  double value = 0.0;  ///< in the metric's unit

  /// False for a metric without a value.
  bool reached_by(double v) const { return larger_is_better(metric) ? v <= value : v >= value; }
};
using EndLimits = std::vector<EndLimit>;

}  // namespace armtune::internal
