#pragma once
// Score of one objective term in one scenario: a metric relative to its reference. The reference itself
// scores 1. A smaller score is always better, also for metrics of which a larger value is better.

#include "sim/metrics/metric.hpp"

namespace armtune::internal {

/// Largest score. A metric relative to its reference, and a violation relative to its limit, count at most
/// this much: one wild value must not drown the rest.
inline constexpr double kLargestRatio = 10.0;

/// Returns the score, 0 to kLargestRatio, of a finite value of a metric that is a goal. reference: above
/// zero.
///
/// With r = value / reference, it is
/// - min(10, r) if less is better;
/// - 1/r if more is better and r >= 1/5, so that twice the bandwidth is worth as much as half the error.
///   Below that 1/r would reach the cap at r = 1/10 and stay there, and a search that starts from a negative
///   margin would see no slope. The curve therefore continues as its own reflection about the point (1/5, 5):
///   10 - 1/(2/5 - r), which is smooth there, finite at zero and below, and falls strictly with r.
double term_score(Metric metric, double value, double reference);

}  // namespace armtune::internal
