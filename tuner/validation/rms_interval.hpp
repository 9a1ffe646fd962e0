#pragma once
// The RMS of errors that follow each other in time, with a confidence interval. Neighbouring windows of a log
// overlap and show similar motions, so their errors are not independent. The interval comes from the means of
// batches of successive squares (batch means: Law and Kelton, Simulation Modeling and Analysis, section 9.5).
// These are nearly independent.

#include <vector>

namespace armtune::internal {

struct RmsInterval {
  double rms = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % interval; NaN if there are fewer than kFewestSquares
};

inline constexpr std::size_t kFewestSquares = 6;

/// Computes the RMS m^(1/2) from squared errors in the order of time, where m is their mean. With b batches,
/// whose means have the standard deviation s, the interval of m is m exp(+-t s / (m b^(1/2))). t: the
/// two-sided 95 % quantile of Student's distribution with b - 1 degrees of freedom. The logarithm keeps the
/// interval positive. b is a quarter of the number of squares, at least 3 and at most 8. All results are NaN
/// without squares.
RmsInterval rms_interval(const std::vector<double>& squares);

}  // namespace armtune::internal
