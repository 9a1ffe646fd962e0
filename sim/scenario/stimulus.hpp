#pragma once
// Describes a test signal (stimulus) that is added to a set point to measure the response of the control
// loop: a step, or a sum of sines. The controller receives the shifted positions, but not the velocity of the
// shift. With the velocity, feed-forward would hide the response of the feedback loop.

#include <variant>
#include <vector>

#include "core/common/types.hpp"

namespace armtune::internal {

struct Step {
  double size = 0.0;  ///< [m]
  double at = 0.0;    ///< [s]
};

/// Harmonics of one base period with equal amplitudes. They form a broadband signal whose Fourier sums over
/// whole base periods do not leak into each other.
struct Multisine {
  double amplitude = 0.0;      ///< of each sine [m]
  double base_period = 0.0;    ///< [s]
  std::vector<int> orders;     ///< cycles per base period, increasing
  std::vector<double> phases;  ///< one per order [rad]
  double from = 0.0;           ///< start; the signal is zero before it [s]
  int periods = 0;             ///< number of base periods that are measured, after one for transients

  /// Returns the start of the measured window [s]; window_end() returns its end.
  double window_start() const { return from + base_period; }
  double window_end() const { return window_start() + periods * base_period; }
};

struct Stimulus {
  enum class On { kPath, kTarget };

  On on = On::kPath;              ///< the tool's path, or the active gaze target
  Vec3 direction = Vec3::Zero();  ///< unit vector, base frame
  std::variant<Step, Multisine> shape;

  /// Returns the time from which the stimulus acts [s].
  double start() const;
  /// Returns the displacement [m] along the direction at time t [s]. Allocates nothing.
  double value(double t) const;
  /// Returns the offset that is added to the position at time t, base frame [m].
  Vec3 at(double t) const { return value(t) * direction; }
};

/// Returns true if t, a multiple k * dt of the control period, has reached `event` [s]. A tolerance makes the
/// result independent of the rounding of k * dt.
inline bool reached(double t, double event) {
  constexpr double kRounding = 1e-9;  // far below any control period, far above 1 ulp of hours
  return t >= event - kRounding;
}

/// Returns phases [rad] that keep the peak of a sum of equal sines low (Schroeder 1970, Synthesis of
/// low-peak-factor signals, IEEE Trans. Inf. Theory 16). The group delay grows with the power of the lower
/// sines. For the orders 1, 2, 3, ..., N, the phase of order n is -pi n (n - 1) / N, and the crest factor is
/// below 2. For orders with wide gaps, the crest factor can reach 3, the value of random phases.
std::vector<double> schroeder_phases(const std::vector<int>& orders);

}  // namespace armtune::internal
