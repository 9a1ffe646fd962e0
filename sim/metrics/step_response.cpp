#include "sim/metrics/step_response.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

constexpr double kRiseFrom = 0.1;
constexpr double kRiseTo = 0.9;
constexpr double kBand = 0.02;
constexpr double kTail = 0.1;

}  // namespace

double StepResponse::crossing(double t, double y, double level) const {
  if (count_ == 0) return t;
  return last_t_ + (t - last_t_) * (level - last_y_) / (y - last_y_);
}

void StepResponse::add(double t, double y) {
  if (t_10_ < 0.0 && y >= kRiseFrom) t_10_ = crossing(t, y, kRiseFrom);
  if (t_90_ < 0.0 && y >= kRiseTo) t_90_ = crossing(t, y, kRiseTo);
  const bool outside = std::abs(y - 1.0) > kBand;
  if (outside_ && !outside) settled_ = crossing(t, y, last_y_ > 1.0 ? 1.0 + kBand : 1.0 - kBand);
  outside_ = outside;
  highest_ = count_ == 0 ? y : std::max(highest_, y);
  if (t >= (1.0 - kTail) * span_) {
    tail_ += 1.0 - y;
    ++tail_count_;
  }
  last_t_ = t;
  last_y_ = y;
  ++count_;
}

double StepResponse::rise_time() const {
  return t_90_ < 0.0 ? NAN : t_90_ - t_10_;
}

double StepResponse::overshoot() const {
  return count_ == 0 ? NAN : std::max(0.0, highest_ - 1.0);
}

double StepResponse::settling_time(double period) const {
  if (count_ == 0) return NAN;
  return outside_ ? last_t_ + period : settled_;
}

double StepResponse::steady_state_error() const {
  return tail_count_ == 0 ? NAN : std::abs(tail_ / static_cast<double>(tail_count_));
}

}  // namespace armtune::internal
