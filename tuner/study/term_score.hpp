#pragma once
// Score of one objective term in one scenario: the metric's value relative to a reference, which is usually
// its value with the start gains. The reference itself scores 1. A smaller score is always better, even if a
// larger value of the metric is better.

#include "sim/metrics/metric.hpp"

namespace armtune::internal {

/// Largest score. Scores and relative violations are limited to this value, so that one extreme value does
/// not outweigh all others.
inline constexpr double kLargestRatio = 10.0;

/// Returns the score, from 0 to kLargestRatio, of a finite value of a metric. For the metric,
/// either larger values count as better, or smaller ones. reference: above zero.
///
/// Let r be value / reference. The score is
/// - min(10, r) if smaller values are better;
/// - 1/r if larger values are better and r >= 1/5. Thus twice the bandwidth is worth as much as half the
///   error;
/// - 10 - 1/(2/5 - r) if larger values are better and r < 1/5. Here min(10, 1/r) would be constant below
///   r = 1/10, so that a search that starts from a negative margin would see no slope. The curve used instead
///   is the reflection of 1/r about the point (1/5, 5). It continues 1/r smoothly, is finite for r <= 0, and
///   decreases strictly with r.
double term_score(Metric metric, double value, double reference);

/// Returns the derivative of term_score by the value. From the largest score on it is 0.
double term_slope(Metric metric, double value, double reference);

}  // namespace armtune::internal
