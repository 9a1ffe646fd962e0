#include "sim/logs/step_histogram.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

constexpr double kWidth = 1e-3;  ///< of a class, in the natural logarithm of the step
constexpr double kShortest = 1e-12;
constexpr double kLongest = 2e5;

}  // namespace

void StepHistogram::add(double step) {
  if (!(step > 0.0) || !std::isfinite(step)) return;
  const double inside = std::clamp(step, kShortest, kLongest);
  Class& found = classes_[static_cast<int>(std::floor(std::log(inside) / kWidth))];
  ++found.count;
  found.sum += step;
  ++count_;
  longest_ = std::max(longest_, step);
}

double StepHistogram::quantile(double share) const {
  const double rank = share * static_cast<double>(count_ - 1);
  long below = 0;
  for (const auto& [index, found] : classes_) {
    below += found.count;
    if (static_cast<double>(below) > rank) return found.sum / static_cast<double>(found.count);
  }
  return longest_;
}

StepSummary StepHistogram::summary() const {
  if (count_ == 0) return {};
  StepSummary summary;
  summary.median = quantile(0.5);
  summary.longest = longest_;
  summary.jitter = 0.5 * (quantile(0.95) - quantile(0.05)) / summary.median;
  for (const auto& [index, found] : classes_) {
    if (found.sum / static_cast<double>(found.count) > kGap * summary.median) summary.gaps += found.count;
  }
  return summary;
}

}  // namespace armtune::internal
