#pragma once
// What is added to a set point so that a loop's response to it can be measured: a step, or a sum of sines.
// The controller sees the shifted positions and is not told that they move, as with a stream of set points
// from elsewhere: feed-forward would hide the feedback loop.

#include <variant>
#include <vector>

#include "core/common/types.hpp"

namespace armtune::internal {

struct Step {
  double size = 0.0;  ///< [m]
  double at = 0.0;    ///< [s]
};

/// Harmonics of one base period, all of one amplitude: a broadband signal whose Fourier sums over whole base
/// periods do not leak into each other.
struct Multisine {
  double amplitude = 0.0;      ///< of each sine [m]
  double base_period = 0.0;    ///< [s]
  std::vector<int> orders;     ///< cycles per base period, increasing
  std::vector<double> phases;  ///< one per order [rad]
  double from = 0.0;           ///< zero before [s]
  int periods = 0;             ///< base periods that are measured, after one for the transients

  /// Of the measured window [s].
  double window_start() const { return from + base_period; }
  double window_end() const { return window_start() + periods * base_period; }
};

struct Stimulus {
  enum class On { kPath, kTarget };

  On on = On::kPath;              ///< the tool's path, or the active gaze target
  Vec3 direction = Vec3::Zero();  ///< unit vector, base frame
  std::variant<Step, Multisine> shape;

  /// From when on it acts [s].
  double start() const;
  /// Along the direction at t [s]: [m]. Allocates nothing.
  double value(double t) const;
  /// Offset to the position, base frame [m].
  Vec3 at(double t) const { return value(t) * direction; }
};

/// Whether t, a multiple of the control period, has come to `event`: rounding of k * dt does not decide.
inline bool reached(double t, double event) {
  constexpr double kRounding = 1e-9;  // far below any control period, far above 1 ulp of hours
  return t >= event - kRounding;
}

/// Phases [rad] that keep the peak of equal sines low: those of Schroeder 1970 (Synthesis of low-peak-factor
/// signals, IEEE Trans. Inf. Theory 16), where the group delay grows with the power of the lower sines. For
/// orders 1 2 3 .. N: phase n = -pi n (n - 1) / N, crest below 2. Orders with wide gaps come to the 3 of
/// random phases.
std::vector<double> schroeder_phases(const std::vector<int>& orders);

}  // namespace armtune::internal
