#pragma once
// Joint friction: viscous, and Coulomb smoothed by tanh. Plant and regressor share this one definition.

#include <cmath>

namespace armtune {

/// Velocity at which tanh takes over from sign [rad/s, m/s].
inline constexpr double kCoulombVelocity = 0.05;

/// Direction of Coulomb friction at velocity qd: tanh(q' / 0.05).
template <typename T>
T coulomb_direction(const T& qd) {
  using std::tanh;
  return tanh(qd * T(1.0 / kCoulombVelocity));
}

}  // namespace armtune
