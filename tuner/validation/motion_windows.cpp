#include "tuner/validation/motion_windows.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Windows overlap by half.
constexpr double kWindowStep = 0.5 * kLongestWindow;
/// Instants through which positions are interpolated.
constexpr std::size_t kCubicPoints = 4;
/// Rounding must not shorten a window.
constexpr double kTimeRounding = 1e-6;

struct TimeSpan {
  double begin = 0.0, end = 0.0;  ///< [s]
};

/// Returns the times in which commands are known: each is held for the median step, and no gap lies between.
std::vector<TimeSpan> commanded_times(const MotionCommands& commands, double gap) {
  const double step = median_step(commands.time);
  std::vector<TimeSpan> spans;
  for (const double t : commands.time) {
    if (spans.empty() || t - spans.back().end > (gap - 1.0) * step) spans.push_back({t, t});
    spans.back().end = t + step;
  }
  return spans;
}

/// Appends the windows of a part of a stretch. part: since its first instant.
void add_windows(const MotionStretch& stretch, std::size_t index, const TimeSpan& part,
                 std::vector<WindowPlace>& out) {
  for (int k = 0;; ++k) {
    const double first = std::ceil((part.begin + k * kWindowStep) / stretch.period - kTimeRounding);
    const double left = part.end - first * stretch.period;
    const bool whole = left >= kLongestWindow - kTimeRounding;
    if (!whole && (k > 0 || left < kShortestWindow)) return;
    out.push_back({index, static_cast<std::size_t>(first), std::min(left, kLongestWindow)});
  }
}

}  // namespace

double median_step(const std::vector<double>& time) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

std::vector<WindowPlace> place_windows(const LoggedMotion& motion, const MotionCommands& commands,
                                       const ValidationThresholds& thresholds) {
  const std::vector<TimeSpan> commanded = commanded_times(commands, thresholds.gap);
  std::vector<WindowPlace> all;
  for (std::size_t s = 0; s < motion.stretches.size(); ++s) {
    const MotionStretch& stretch = motion.stretches[s];
    if (stretch.instants.size() < kCubicPoints) continue;
    const double end = static_cast<double>(stretch.instants.size() - 1) * stretch.period;
    for (const TimeSpan& span : commanded) {
      const TimeSpan part{std::max(0.0, span.begin - stretch.begin), std::min(end, span.end - stretch.begin)};
      if (part.end > part.begin) add_windows(stretch, s, part, all);
    }
  }
  if (all.size() <= kMostWindows) return all;
  std::vector<WindowPlace> kept;
  for (std::size_t i = 0; i < kMostWindows; ++i) kept.push_back(all[i * all.size() / kMostWindows]);
  return kept;
}

JointVector position_at(const MotionStretch& stretch, double time) {
  const double at = time / stretch.period;
  const std::size_t last = stretch.instants.size() - kCubicPoints;
  const auto first =
      static_cast<std::size_t>(std::clamp(std::floor(at) - 1.0, 0.0, static_cast<double>(last)));
  JointVector q = JointVector::Zero(stretch.instants.front().q.size());
  for (std::size_t k = first; k < first + kCubicPoints; ++k) {  // Lagrange's polynomial
    double weight = 1.0;
    for (std::size_t l = first; l < first + kCubicPoints; ++l) {
      if (l != k) {
        weight *= (at - static_cast<double>(l)) / (static_cast<double>(k) - static_cast<double>(l));
      }
    }
    q += weight * stretch.instants[k].q;
  }
  return q;
}

}  // namespace armtune::internal
