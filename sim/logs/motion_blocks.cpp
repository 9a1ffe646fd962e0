#include "sim/logs/motion_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace armtune::internal {
namespace {

constexpr int kSteps = 10;
constexpr double kDuration = 0.05;
constexpr std::size_t kMostBlocks = 500;
constexpr std::size_t kLeastBlocks = 16;
constexpr std::size_t kMostNumbers = std::size_t{1} << 18;
/// Smallest number of stretches for a relation.
constexpr int kEnough = 8;

std::size_t capacity(std::size_t channels) {
  return std::clamp(kMostNumbers / std::max<std::size_t>(channels, 1), kLeastBlocks, kMostBlocks);
}

/// Sums for the regression y = k x through the origin.
struct Sums {
  double xx = 0.0, xy = 0.0, yy = 0.0;
  int count = 0;

  void add(double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    xx += x * x;
    xy += x * y;
    yy += y * y;
    ++count;
  }
  Relation relation() const {
    if (count < kEnough || !(xx > 0.0) || !(yy > 0.0) || !std::isfinite(xx * yy)) return {};
    return {xy / xx, xy / std::sqrt(xx * yy)};
  }
};

double at(const std::vector<double>& values, std::size_t channel) {
  return channel < values.size() ? values[channel] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void MotionBlocks::add(double time, const std::vector<double>& value) {
  if (steps_ >= 0) {
    const double step = time - last_time_;
    if (!(step > 0.0)) return;
    open_.duration += step;
    open_.integral.resize(std::max(open_.integral.size(), value.size()),
                          std::numeric_limits<double>::quiet_NaN());
    for (std::size_t c = 0; c < open_.integral.size(); ++c)
      open_.integral[c] += 0.5 * step * (at(last_, c) + at(value, c));
  }
  last_time_ = time;
  last_ = value;
  ++steps_;
  if (steps_ > 0 && (steps_ < kSteps || open_.duration < kDuration)) return;
  if (steps_ > 0) finish(value);
  steps_ = 0;
  first_ = value;
  open_.duration = 0.0;
  open_.integral.assign(value.size(), 0.0);
}

void MotionBlocks::finish(const std::vector<double>& value) {
  if (seen_++ % step_ != 0) return;
  open_.change.resize(open_.integral.size());
  for (std::size_t c = 0; c < open_.change.size(); ++c) open_.change[c] = at(value, c) - at(first_, c);
  kept_.push_back(open_);
  while (kept_.size() > capacity(value.size())) {
    for (std::size_t i = 0; 2 * i < kept_.size(); ++i) std::swap(kept_[i], kept_[2 * i]);
    kept_.resize((kept_.size() + 1) / 2);
    step_ *= 2;
  }
}

Relation MotionBlocks::derivative(std::size_t a, std::size_t b) const {
  Sums sums;
  for (const Block& block : kept_) sums.add(at(block.change, a), at(block.integral, b));
  return sums.relation();
}

Relation MotionBlocks::multiple(std::size_t a, std::size_t b) const {
  double mean_a = 0.0;
  double mean_b = 0.0;
  double count = 0.0;
  const auto each_mean = [&](auto&& use) {
    for (const Block& block : kept_) {
      const double x = at(block.integral, a) / block.duration;
      const double y = at(block.integral, b) / block.duration;
      if (std::isfinite(x) && std::isfinite(y)) use(x, y);
    }
  };
  each_mean([&](double x, double y) {
    mean_a += x;
    mean_b += y;
    count += 1.0;
  });
  Sums sums;
  each_mean([&](double x, double y) { sums.add(x - mean_a / count, y - mean_b / count); });
  return sums.relation();
}

double MotionBlocks::rms_change(std::size_t channel) const {
  double squares = 0.0;
  int count = 0;
  for (const Block& block : kept_) {
    const double change = at(block.change, channel);
    if (!std::isfinite(change)) continue;
    squares += change * change;
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : 0.0;
}

}  // namespace armtune::internal
