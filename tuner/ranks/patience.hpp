#pragma once
// Provides a clock and a sleep function for loops that wait for a message, so that such a loop does not keep
// a processor busy.

#include <algorithm>
#include <chrono>
#include <thread>

namespace armtune::internal {

/// A clock of wall time that leaves out time in which the process was stopped (Ctrl-Z, a suspended job).
/// Between two calls of look() at most one second counts.
class RunningTime {
 public:
  /// Returns the time so far [s]. Call it often.
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

/// One wait for a message. It begins with the construction of the object.
class Patience {
 public:
  /// Returns the time waited so far [s], as RunningTime counts it.
  double seconds() { return time_.look(); }
  /// Sleeps for 2 % of the time waited so far, but for at least 0.1 ms and at most 1 ms. The caller thus
  /// notices the message at most 1 ms after it has arrived.
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
