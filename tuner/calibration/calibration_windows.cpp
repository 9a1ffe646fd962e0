#include "tuner/calibration/calibration_windows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

constexpr Eigen::Index kFewestSamples = 20;
constexpr double kLongestDelay = 0.05;  ///< of a command, for windows to begin [s]
constexpr double kLeastNoise = 1e-7;
constexpr double kNormalPerMedian = 1.4826;  ///< of a normal distribution, from the median of its size

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Appends windows of at most `length` that divide the samples first .. last - 1 equally.
void divide(const JointLog& log, Eigen::Index first, Eigen::Index last, double length, double shortest,
            std::vector<LogWindow>& windows) {
  if (last - first < kFewestSamples) return;
  const double whole =
      log.time[static_cast<std::size_t>(last - 1)] - log.time[static_cast<std::size_t>(first)];
  if (whole < shortest) return;
  const auto parts = std::max<Eigen::Index>(1, std::lround(whole / length));
  for (Eigen::Index k = 0; k < parts; ++k) {
    const Eigen::Index begin = first + (last - first) * k / parts;
    const Eigen::Index end = first + (last - first) * (k + 1) / parts;
    windows.push_back({begin, end - begin});
  }
}

}  // namespace

TimeSpan known_commands(const MotionCommands& commands) {
  const double begin = commands.servo ? kServoWarmUp : kLongestDelay;
  return {commands.time.front() + begin, commands.time.back()};
}

WindowPlan window_plan(const JointLog& log, const TimeSpan& span, const WindowLengths& lengths) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < log.time.size(); ++i) steps.push_back(log.time[i] - log.time[i - 1]);
  WindowPlan plan{sampling_period(log), {}, {}};
  const double gap = (CommandSignal::kMostLost + 1.5) * plan.period;
  const double block = std::min(lengths.block, (log.time.back() - log.time.front()) / 5.0);
  enum class Part { kNone, kFitted, kHeldOut };
  const auto part_of = [&](Eigen::Index i) {
    const double t = log.time[static_cast<std::size_t>(i)];
    if (t < span.from || t > span.to) return Part::kNone;
    return static_cast<long>((t - log.time.front()) / block) % 5 == 2 ? Part::kHeldOut : Part::kFitted;
  };
  Eigen::Index first = 0;
  for (Eigen::Index i = 1; i <= log.samples(); ++i) {
    const Part part = part_of(first);
    if (i < log.samples() && steps[static_cast<std::size_t>(i - 1)] <= gap && part_of(i) == part) continue;
    if (part == Part::kHeldOut) divide(log, first, i, block, 0.8 * block, plan.held_out);
    if (part == Part::kFitted) divide(log, first, i, lengths.fitted, 0.3 * lengths.fitted, plan.fitted);
    first = i;
  }
  if (plan.fitted.empty() || plan.held_out.empty())
    throw InputError(
        InputPlace{log.source, 0, "time"},
        {"the log is too short, or gaps divide it into parts that are too short; record a longer one",
         fmt::format("{} s", log.time.back() - log.time.front()), "20 s without gaps"});
  return plan;
}

Eigen::VectorXd encoder_noise(const JointLog& log, double period) {
  Eigen::VectorXd noise(log.q.cols());
  const double regular = 0.25 * period;
  for (Eigen::Index j = 0; j < log.q.cols(); ++j) {
    std::vector<double> sizes;
    for (Eigen::Index i = 3; i < log.samples(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (std::abs(log.time[k] - log.time[k - 3] - 3.0 * period) > regular) continue;
      sizes.push_back(
          std::abs(log.q(i, j) - 3.0 * log.q(i - 1, j) + 3.0 * log.q(i - 2, j) - log.q(i - 3, j)));
    }
    // The variance of a third difference of white noise is 1 + 9 + 9 + 1 times that of the noise.
    noise[j] = sizes.empty() ? kLeastNoise : kNormalPerMedian * median(sizes) / std::sqrt(20.0);
  }
  return noise.cwiseMax(kLeastNoise);
}

}  // namespace armtune::internal
