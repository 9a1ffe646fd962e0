#pragma once
// Waiting for a message that is asked for again and again, without keeping a processor busy.

#include <algorithm>
#include <chrono>
#include <thread>

namespace armtune {

class Patience {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }
  /// A fiftieth of the wait so far, between 0.1 and 1 ms: what is waited for comes late by 2 % at most, or by
  /// less than a millisecond.
  void sleep() const {
    constexpr double kShortest = 1e-4;
    constexpr double kLongest = 1e-3;
    std::this_thread::sleep_for(
        std::chrono::duration<double>(std::clamp(seconds() / 50.0, kShortest, kLongest)));
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point began_ = Clock::now();
};

}  // namespace armtune
