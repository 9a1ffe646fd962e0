#pragma once
// Compares the tracking errors at the beginning and at the end of a long rollout, to find errors that grow
// with time.

#include <array>

#include "sim/metrics/accumulator.hpp"

namespace armtune::internal {

/// A part of a rollout [s].
struct TimeWindow {
  double from = 0.0;
  double to = 0.0;
};

/// Returns two windows of equal length in a rollout of `duration` seconds: one after the first minute, one at
/// its end. They are ten minutes long; if there is less time, the rest is halved. Of a rollout under five
/// minutes, only the first fifth is skipped.
std::array<TimeWindow, 2> compared_windows(double duration);

class ErrorWindows {
 public:
  /// start_time, duration: of the scenario [s]; period: of control [s].
  ErrorWindows(double start_time, double duration, double period);

  /// Takes in one control period; must be called once per period. It counts what the metrics count as
  /// tracking: followTrajectory from 1 s after it was entered, outside a slerp. The second after a change of
  /// the target is left out, since the distance to the next target is no error that grows.
  void look(const Observation& o);

  /// The errors of one window.
  struct Errors {
    Spread position;     ///< [m]
    Spread orientation;  ///< [rad]
  };
  /// Returns the errors of the first window (0) or the last (1).
  const Errors& errors(std::size_t window) const { return errors_[window]; }

  /// Returns the larger of the position's and the orientation's growth. Growth is the RMS (peak) of the last
  /// window over that of the first. NaN if a window saw no tracking.
  double rms_growth() const;
  double peak_growth() const;

 private:
  double start_time_;
  double period_;
  std::array<TimeWindow, 2> windows_;
  std::array<Errors, 2> errors_;
  ControlState state_ = ControlState::kLeaveSingularity;
  std::size_t target_ = 0;
  double entered_ = 0.0;  ///< time of the last change of state or target [s]
};

}  // namespace armtune::internal
