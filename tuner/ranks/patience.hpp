#pragma once
// Waiting for a message that is asked for again and again, without keeping a processor busy.

#include <algorithm>
#include <chrono>
#include <thread>

namespace armtune::internal {

/// Wall clock time, without that in which the process was stopped (Ctrl-Z, a suspended job): between two
/// looks at it no more than a second counts.
class RunningTime {
 public:
  /// [s], looked at often while it runs
  double look() {
    constexpr double kLargestGap = 1.0;
    const auto now = Clock::now();
    seconds_ += std::min(kLargestGap, std::chrono::duration<double>(now - last_).count());
    last_ = now;
    return seconds_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
  double seconds_ = 0.0;
};

class Patience {
 public:
  double seconds() { return time_.look(); }
  /// A fiftieth of the wait so far, between 0.1 and 1 ms: what is waited for comes late by 2 % at most, or by
  /// less than a millisecond.
  void sleep() {
    constexpr double kShortest = 1e-4;
    constexpr double kLongest = 1e-3;
    std::this_thread::sleep_for(
        std::chrono::duration<double>(std::clamp(seconds() / 50.0, kShortest, kLongest)));
  }

 private:
  RunningTime time_;
};

}  // namespace armtune::internal
