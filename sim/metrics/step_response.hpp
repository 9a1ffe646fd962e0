#pragma once
// Rise time, overshoot, settling time and steady-state error of a step response (Ogata, Modern Control
// Engineering, 5.3), taken sample by sample.

namespace armtune::internal {

/// Of a signal that is to go from 0 to 1. Times are between samples where the straight line crosses.
class StepResponse {
 public:
  /// span: time from the step to the end of what will be seen [s].
  explicit StepResponse(double span) : span_(span) {}

  /// t: time since the step [s], increasing from 0. y: the response over the step's size.
  void add(double t, double y);

  /// From the first 10 % to the first 90 % [s]; NaN if it never came to 90 %.
  double rise_time() const;
  /// By how much it was ever above 1; NaN before the first sample.
  double overshoot() const;
  /// Until it is within 0.02 of 1 for good [s]; the last sample's t plus `period` if it is not.
  double settling_time(double period) const;
  /// |mean of 1 - y| over the last tenth of the span; NaN if that was not seen.
  double steady_state_error() const;

 private:
  double crossing(double t, double y, double level) const;

  double span_;
  long count_ = 0;
  double last_t_ = 0.0, last_y_ = 0.0;
  double t_10_ = -1.0, t_90_ = -1.0;  ///< negative: not yet
  double highest_ = 0.0;
  bool outside_ = false;
  double settled_ = 0.0;
  double tail_ = 0.0;  ///< sum of 1 - y
  long tail_count_ = 0;
};

}  // namespace armtune::internal
