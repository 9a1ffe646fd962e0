#pragma once
// Statistics of samples: quantiles, conditional value at risk, confidence intervals.

#include <span>
#include <utility>
#include <vector>

namespace armtune::internal {

/// Returns the p-quantile, that is, the value below which a share p of the values lies. It is interpolated
/// between two neighbouring values (Hyndman and Fan, Sample quantiles in statistical packages, 1996,
/// definition 7). sorted: the values in ascending order, at least one; p: in [0, 1].
double quantile(std::span<const double> sorted, double p);

/// Returns the conditional value at risk. For n values, this is the mean of the (1 - p) * n largest ones. If
/// (1 - p) * n is not a whole number, the smallest of them is weighted with its fractional part. sorted: the
/// values in ascending order, at least one; p: in [0, 1).
double conditional_value_at_risk(std::span<const double> sorted, double p);

/// Returns the 95 % confidence interval of a probability after `successes` in `trials` (>= 1) (Wilson, 1927).
/// Unlike the interval of the normal approximation, it is also valid for probabilities near 0 or 1.
std::pair<double, double> wilson_interval(std::size_t successes, std::size_t trials);

}  // namespace armtune::internal
