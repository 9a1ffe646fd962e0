#pragma once
// Defines limits of metrics at which a rollout (one simulated scenario) is abandoned to save time. Each of
// these metrics is a maximum, a minimum or a count. Once such a metric is beyond its limit, it stays there,
// and the rest of the rollout is useless.

#include <vector>

#include "sim/metrics/metric.hpp"

namespace armtune::internal {

/// A limit on a metric that only worsens. The rollout ends in the first period in which the metric is at
/// `value` or worse.
struct EndLimit {
  Metric metric = Metric::kJointVelocityMaxRatio;
  double value = 0.0;  ///< in the metric's unit

  /// True if v, the metric's value so far, is at the limit or worse. False for NaN, a metric without a value.
  bool reached_by(double v) const { return larger_is_better(metric) ? v <= value : v >= value; }
};
using EndLimits = std::vector<EndLimit>;

}  // namespace armtune::internal
