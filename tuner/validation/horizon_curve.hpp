#pragma once
// Position errors of simulated windows against the time since their start, the horizon.

#include <vector>

#include "tuner/validation/window_run.hpp"

namespace armtune::internal {

/// Position errors of one joint against the horizon. Each vector has an entry for every horizon (H).
struct HorizonCurve {
  std::vector<double> rms;             ///< RMS over the windows of simulated minus logged position [rad, m]
  std::vector<double> low, high;       ///< 95 % interval of rms (rms_interval.hpp); NaN: too few windows
  std::vector<double> stays;           ///< RMS error of the prediction "the joint stays where it is"
  std::vector<double> keeps_velocity;  ///< RMS error of the prediction "it keeps its velocity"
  /// Slope of the error over the logged displacement since the start. Below zero, the simulated joint moves
  /// less than the real one, and by this share of its displacement.
  std::vector<double> slope;

  /// Returns the yardstick at a horizon: the smaller error of the two predictions without a model.
  double yardstick(std::size_t horizon) const;
};

/// Computes the curve of a joint at the first H horizons. Windows count up to where their runs end. The
/// results are NaN, and the slope 0, at horizons that no window reaches.
HorizonCurve horizon_curve(const std::vector<WindowRun>& runs, int joint, std::size_t horizons);

}  // namespace armtune::internal
