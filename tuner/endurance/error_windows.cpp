#include "tuner/endurance/error_windows.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

constexpr double kFirstMinute = 60.0;     // s; adaptation from wrong start parameters settles in this time
constexpr double kLongestWindow = 600.0;  // s
/// Errors count only from this long after followTrajectory was entered or the target changed [s].
constexpr double kSettlingTime = 1.0;

double growth(double last, double first) {
  return first > 0.0 ? last / first : NAN;
}

}  // namespace

std::array<TimeWindow, 2> compared_windows(double duration) {
  const double skipped = std::min(kFirstMinute, 0.2 * duration);
  const double length = std::min(kLongestWindow, 0.5 * (duration - skipped));
  return {{{skipped, skipped + length}, {duration - length, duration}}};
}

ErrorWindows::ErrorWindows(double start_time, double duration, double period)
    : start_time_(start_time), period_(period), windows_(compared_windows(duration)) {}

void ErrorWindows::look(const Observation& o) {
  if (o.control->state != state_ || o.target != target_) {
    state_ = o.control->state;
    target_ = o.target;
    entered_ = o.time;
  }
  if (state_ != ControlState::kFollowTrajectory || o.control->slerping ||
      o.time - entered_ < kSettlingTime - 0.5 * period_) {
    return;
  }
  const double time = o.time - start_time_;
  for (std::size_t w = 0; w < windows_.size(); ++w) {
    if (time < windows_[w].from || time >= windows_[w].to) continue;
    errors_[w].position.add(o.error.head<3>().norm());
    errors_[w].orientation.add(o.error.tail<3>().norm());
  }
}

double ErrorWindows::rms_growth() const {
  return std::fmax(growth(errors_[1].position.rms(), errors_[0].position.rms()),
                   growth(errors_[1].orientation.rms(), errors_[0].orientation.rms()));
}

double ErrorWindows::peak_growth() const {
  return std::fmax(growth(errors_[1].position.max(), errors_[0].position.max()),
                   growth(errors_[1].orientation.max(), errors_[0].orientation.max()));
}

}  // namespace armtune::internal
