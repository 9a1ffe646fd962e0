#pragma once
// Statistics of samples: quantiles, conditional value at risk, confidence intervals.

#include <span>
#include <utility>
#include <vector>

namespace armtune::internal {

/// Returns the value below which a share p in [0, 1] of the values lies, interpolated between neighbours
/// (Hyndman and Fan, Sample quantiles in statistical packages, 1996, definition 7). sorted: ascending, at
/// least one.
double quantile(std::span<const double> sorted, double p);

/// Returns the mean of the worst (largest) share 1 - p of the values, p in [0, 1): the conditional value at
/// risk. The value at the edge counts with the part of it that belongs to the share. sorted: ascending, at
/// least one.
double conditional_value_at_risk(std::span<const double> sorted, double p);

/// Returns the 95 % confidence interval of a probability after `successes` in `trials` (>= 1) (Wilson, 1927).
/// Unlike the interval of the normal approximation, it is valid for yields near 1.
std::pair<double, double> wilson_interval(std::size_t successes, std::size_t trials);

}  // namespace armtune::internal
