#pragma once
// Tracking errors at the beginning and at the end of a long rollout: whether they grow with time.

#include <array>

#include "sim/metrics/accumulator.hpp"

namespace armtune::internal {

/// A part of a rollout [s].
struct TimeWindow {
  double from = 0.0;
  double to = 0.0;
};

/// Two windows of equal length in a rollout of `duration` seconds: one after the first minute, one at its
/// end. They are ten minutes long, or shorter where there is less time: the whole rest is then halved.
std::array<TimeWindow, 2> compared_windows(double duration);

class ErrorWindows {
 public:
  /// start_time, duration: of the scenario [s]; period: of control [s].
  ErrorWindows(double start_time, double duration, double period);

  /// To be called once per control period. Counts what the metrics count as tracking, followTrajectory from
  /// 1 s after it was entered, outside a slerp, but for the second after a change of the target: how far the
  /// next one is away is no error that grows.
  void look(const Observation& o);

  /// The errors of one quantity in the first window (0) and in the last (1).
  struct Errors {
    Spread position;     ///< [m]
    Spread orientation;  ///< [rad]
  };
  const Errors& errors(std::size_t window) const { return errors_[window]; }

  /// The larger of the position's and the orientation's growth: RMS (peak) of the last window over that of
  /// the first. NaN if a window saw no tracking.
  double rms_growth() const;
  double peak_growth() const;

 private:
  double start_time_;
  double period_;
  std::array<TimeWindow, 2> windows_;
  std::array<Errors, 2> errors_;
  ControlState state_ = ControlState::kLeaveSingularity;
  std::size_t target_ = 0;
  double entered_ = 0.0;  ///< when state or target changed last [s]
};

}  // namespace armtune::internal
