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

/// Returns two windows of equal length in a rollout of `duration` seconds: one after the first minute, and
/// one at its end. Each is ten minutes long, or half of the time after the first minute if that is shorter.
/// If the rollout is shorter than five minutes, its first fifth is skipped instead of its first minute.
std::array<TimeWindow, 2> compared_windows(double duration);

class ErrorWindows {
 public:
  /// start_time, duration: those of the scenario [s]. period: control period [s].
  ErrorWindows(double start_time, double duration, double period);

  /// Adds the errors of one control period; must be called once per period. As in the metrics, errors count
  /// only while the arm tracks its path: in the control state followTrajectory, from 1 s after this state was
  /// entered, and not while the orientation reference turns (slerp). The first second after a change of
  /// target is left out too, because the distance to a new target is not an error that grows with time.
  void look(const Observation& o);

  /// The errors of one window.
  struct Errors {
    Spread position;     ///< [m]
    Spread orientation;  ///< [rad]
  };
  /// Returns the errors of the first window (0) or of the last window (1).
  const Errors& errors(std::size_t window) const { return errors_[window]; }

  /// Returns the growth of the position error or of the orientation error, whichever is larger. Growth is the
  /// RMS (or the peak) in the last window divided by that in the first. NaN if a window contains no tracking.
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
