#pragma once
// Joint friction: viscous friction, and Coulomb friction with its sign function smoothed by tanh. The
// simulated arm and the regressor of its dynamics (slotine_li.hpp) use the same definition.

#include <cmath>

#include "core/common/select.hpp"
#include "core/common/types.hpp"
#include "core/common/vector_math.hpp"

namespace armtune::internal {

/// Velocity scale of the tanh that replaces the sign function [rad/s, m/s].
inline constexpr double kCoulombVelocity = 0.05;

/// Returns the direction of Coulomb friction at the velocity qd = q': tanh(q' / 0.05). It needs one
/// exponential, and its absolute error is about 1e-16. Near zero, the standard library's tanh has a smaller
/// relative error, but it takes three times as long.
template <typename T>
T coulomb_direction(const T& qd) {
  using std::exp;
  return T(1) - T(2) / (T(1) + exp(qd * T(2.0 / kCoulombVelocity)));
}

/// Returns the directions of two joints at once.
inline vector_math::Double2 coulomb_direction(const vector_math::Double2& qd) {
  return 1.0 - 2.0 / (1.0 + vector_math::exponential(qd * (2.0 / kCoulombVelocity)));
}
inline double coulomb_direction(double qd) {
  return coulomb_direction(vector_math::Double2{qd, qd})[0];
}

/// Computes the directions of all joints (n).
template <typename T>
void coulomb_directions(const JointVectorT<T>& qd, JointVectorT<T>& directions) {
  directions.resize(qd.size());
  for (Eigen::Index i = 0; i < qd.size(); ++i) directions[i] = coulomb_direction(qd[i]);
}
inline void coulomb_directions(const JointVector& qd, JointVector& directions) {
  const Eigen::Index n = qd.size();
  directions.resize(n);
  for (Eigen::Index i = 0; i + 1 < n; i += 2) {
    const vector_math::Double2 both = coulomb_direction(vector_math::Double2{qd[i], qd[i + 1]});
    directions[i] = both[0];
    directions[i + 1] = both[1];
  }
  if (n % 2 == 1) directions[n - 1] = coulomb_direction(qd[n - 1]);
}

/// Computes the directions of all joints (n). If no joint has Coulomb friction, they have no effect and are
/// set to zero. coefficients: Coulomb friction of the joints (n).
template <typename T>
void coulomb_directions(const JointVectorT<T>& qd, const JointVectorT<T>& coefficients,
                        JointVectorT<T>& directions) {
  T largest = coefficients[0];
  for (Eigen::Index i = 1; i < coefficients.size(); ++i) {
    largest = select(coefficients[i] > largest, coefficients[i], largest);
  }
  if (any(largest > T(0))) {
    coulomb_directions(qd, directions);
  } else {
    directions.setZero(qd.size());
  }
}

}  // namespace armtune::internal
