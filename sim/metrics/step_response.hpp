#pragma once
// Computes rise time, overshoot, settling time and steady-state error of a step response (Ogata, Modern
// Control Engineering, 5.3), sample by sample.

namespace armtune::internal {

/// The response of a signal that should go from 0 to 1. The time at which the response crosses a level is
/// interpolated linearly between two samples.
class StepResponse {
 public:
  /// span: time from the step to the end of the measurement [s].
  explicit StepResponse(double span) : span_(span) {}

  /// Adds a sample. t: time since the step [s], increasing from 0. y: the response divided by the step size.
  void add(double t, double y);

  /// Returns the time from the first crossing of 10 % to the first crossing of 90 % [s]; NaN if the response
  /// never reached 90 %.
  double rise_time() const;
  /// Returns the largest amount by which the response exceeded 1; 0 if it never did. Returns NaN before the
  /// first sample.
  double overshoot() const;
  /// Returns the time from the step until the response stays between 0.98 and 1.02 [s]. If the last sample is
  /// outside this band, returns its t plus `period`. Returns NaN before the first sample.
  double settling_time(double period) const;
  /// Returns |mean of 1 - y| over the last tenth of the span; NaN without samples in it.
  double steady_state_error() const;

 private:
  double crossing(double t, double y, double level) const;

  double span_;
  long count_ = 0;
  double last_t_ = 0.0, last_y_ = 0.0;
  double t_10_ = -1.0, t_90_ = -1.0;  ///< first crossings of 10 % and 90 % [s]; negative: not yet crossed
  double highest_ = 0.0;
  bool outside_ = false;
  double settled_ = 0.0;
  double tail_ = 0.0;  ///< sum of 1 - y over the last tenth of the span
  long tail_count_ = 0;
};

}  // namespace armtune::internal
