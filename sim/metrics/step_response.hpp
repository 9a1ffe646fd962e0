#pragma once
// Rise time, overshoot, settling time and steady-state error of a step response (Ogata, Modern Control
// Engineering, 5.3), computed sample by sample.

namespace armtune::internal {

/// The response of a signal that should go from 0 to 1. A crossing time lies between two samples, where the
/// straight line through them crosses the level.
class StepResponse {
 public:
  /// span: time from the step to the end of the samples to come [s].
  explicit StepResponse(double span) : span_(span) {}

  /// Adds a sample. t: time since the step [s], increasing from 0. y: the response over the step's size.
  void add(double t, double y);

  /// Returns the time from the first 10 % to the first 90 % [s]; NaN if the response never reached 90 %.
  double rise_time() const;
  /// Returns how far the response ever rose above 1, at least 0; NaN before the first sample.
  double overshoot() const;
  /// Returns the time until the response stays within 0.02 of 1 [s]. If it does not, returns the last
  /// sample's t plus `period`. Returns NaN before the first sample.
  double settling_time(double period) const;
  /// Returns |mean of 1 - y| over the last tenth of the span; NaN without samples in it.
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
