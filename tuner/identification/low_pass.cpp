#include "tuner/identification/low_pass.hpp"

#include <array>
#include <cmath>

namespace armtune::internal {
namespace {

/// Half length of the window in units of 1 / cutoff. The main lobe of its spectrum then ends half a cutoff
/// away.
constexpr double kHalfLength = 4.0;

/// The value of a function of time, with its first two derivatives.
struct Wave {
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;
};

Wave blackman_harris(double t, double half_length) {
  constexpr std::array<double, 4> kTerms = {0.35875, 0.48829, 0.14128, 0.01168};
  Wave window;
  for (std::size_t k = 0; k < kTerms.size(); ++k) {
    const double w = static_cast<double>(k) * M_PI / half_length;
    window.value += kTerms[k] * std::cos(w * t);
    window.first -= kTerms[k] * w * std::sin(w * t);
    window.second -= kTerms[k] * w * w * std::cos(w * t);
  }
  return window;
}

/// Returns sin(w t) / (w t) with its first two derivatives.
Wave sinc(double t, double w) {
  const double x = w * t;
  if (std::abs(x) < 1e-3) return {1.0 - x * x / 6.0, -w * x / 3.0, -w * w / 3.0 * (1.0 - 0.3 * x * x)};
  const double s = std::sin(x) / x;
  const double slope = (std::cos(x) - s) / x;
  return {s, w * slope, w * w * (-s - 2.0 * slope / x)};
}

}  // namespace

double low_pass_half_length(double cutoff) {
  return kHalfLength / cutoff;
}

LowPass low_pass(double cutoff, double period, double delay) {
  const double half_length = low_pass_half_length(cutoff);
  LowPass filter;
  filter.half = static_cast<int>(half_length / period);
  const int n = filter.length();
  filter.value.resize(n);
  filter.first.resize(n);
  filter.second.resize(n);
  Eigen::VectorXd t(n);
  for (int k = 0; k < n; ++k) {
    t[k] = (k - filter.half) * period + delay;
    const Wave s = sinc(t[k], 2.0 * M_PI * cutoff);
    const Wave w = blackman_harris(t[k], half_length);
    filter.value[k] = s.value * w.value;
    // A sample at time t has the weight h(now - t), so odd derivatives change their sign.
    filter.first[k] = -(s.first * w.value + s.value * w.first);
    filter.second[k] = s.second * w.value + 2.0 * s.first * w.first + s.value * w.second;
  }
  // The sums over the samples differ slightly from the integrals. These corrections make them exact, so that
  // no offset leaks into a derivative.
  filter.value /= filter.value.sum();
  filter.first /= filter.first.dot(t);
  filter.second -= filter.second.sum() * filter.value;
  filter.second /= 0.5 * filter.second.dot(t.cwiseAbs2());
  return filter;
}

}  // namespace armtune::internal
