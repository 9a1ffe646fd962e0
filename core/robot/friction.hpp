#pragma once
// Joint friction: viscous, and Coulomb smoothed by tanh. Plant and regressor share this one definition.

#include <cmath>

namespace armtune {

/// Velocity at which tanh takes over from sign [rad/s, m/s].
inline constexpr double kCoulombVelocity = 0.05;

/// Direction of Coulomb friction at velocity qd: tanh(q' / 0.05). From one exponential, exact to 1e-16: the
/// library's tanh takes three times as long to keep the relative accuracy of results near zero as well.
template <typename T>
T coulomb_direction(const T& qd) {
  using std::exp;
  return T(1) - T(2) / (T(1) + exp(qd * T(2.0 / kCoulombVelocity)));
}

}  // namespace armtune
