#pragma once
// Computes the angular velocity w and acceleration w' of a frame with the orientation exp(psi(t)), where psi
// is a rotation vector. With the left Jacobian J_l of SO(3), w = J_l psi',
//   J_l = 1 + a [psi] + b [psi]^2,   a = (1 - cos(angle)) / angle^2,   b = (angle - sin(angle)) / angle^3,
// where angle = |psi|, and [psi] is the cross product matrix of psi. Source: Chirikjian, Stochastic Models,
// Information Theory, and Lie Groups, vol. 2, section 10.6.

#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/rotation.hpp"

namespace armtune::internal {

/// The angular velocity w [rad/s] and acceleration w' [rad/s^2] of a frame, in the base frame.
struct TurnRate {
  Vec3 velocity = Vec3::Zero();
  Vec3 acceleration = Vec3::Zero();
};

/// Returns w and w' of exp(psi). psi: rotation vector [rad] with its first and second derivatives. The result
/// is well conditioned for |psi| <= pi.
inline TurnRate rotation_rate(const MotionPoint<Vec3>& psi) {
  const double x = psi.position.squaredNorm();
  const double angle = std::sqrt(x);
  double a = 0.0;
  double b = 0.0;
  double a1 = 0.0;  // (da / d angle) / angle
  double b1 = 0.0;
  if (x < 1e-2) {
    // The quotients lose digits; their series are exact to 1e-16 here.
    a = 1.0 / 2.0 - x * (1.0 / 24.0 - x * (1.0 / 720.0 - x * (1.0 / 40320.0 - x / 3628800.0)));
    b = 1.0 / 6.0 - x * (1.0 / 120.0 - x * (1.0 / 5040.0 - x * (1.0 / 362880.0 - x / 39916800.0)));
    a1 = -1.0 / 12.0 + x * (1.0 / 180.0 - x * (1.0 / 6720.0 - x * (1.0 / 453600.0 - x / 47900160.0)));
    b1 = -1.0 / 60.0 + x * (1.0 / 1260.0 - x * (1.0 / 60480.0 - x * (1.0 / 4989600.0 - x / 622702080.0)));
  } else {
    const double sine = std::sin(angle);
    const double versine = 1.0 - std::cos(angle);
    a = versine / x;
    b = (angle - sine) / (x * angle);
    a1 = (angle * sine - 2.0 * versine) / (x * x);
    b1 = (versine - 3.0 * (angle - sine) / angle) / (x * x);
  }
  const double half_x_dot = psi.position.dot(psi.velocity);  // angle * angle'
  const Vec3 across = psi.position.cross(psi.velocity);
  const Vec3 across2 = psi.position.cross(across);
  const Vec3 ddot_across = psi.position.cross(psi.acceleration);
  TurnRate rate;
  rate.velocity = psi.velocity + a * across + b * across2;
  rate.acceleration = psi.acceleration + a * ddot_across + b * psi.position.cross(ddot_across) +
                      half_x_dot * (a1 * across + b1 * across2) + b * psi.velocity.cross(across);
  return rate;
}

/// Computes the inverse of rotation_rate: returns psi with psi' and psi''. psi: rotation vector [rad] from a
/// fixed orientation to one that turns with `rate`; |psi| < 2 pi.
///   psi' = J_l^-1 w,   psi'' = J_l^-1 (w' - J_l' psi'),   J_l^-1 = 1 - [psi] / 2 + c [psi]^2,
///   c = (1 - angle * sin(angle) / (2 (1 - cos(angle)))) / angle^2.
inline MotionPoint<Vec3> rotation_vector_motion(const Vec3& psi, const TurnRate& rate) {
  const double x = psi.squaredNorm();
  double c = 0.0;
  if (x < 1e-2) {
    c = 1.0 / 12.0 + x * (1.0 / 720.0 + x * (1.0 / 30240.0 + x / 1209600.0));
  } else {
    const double angle = std::sqrt(x);
    c = (1.0 - 0.5 * angle * std::sin(angle) / (1.0 - std::cos(angle))) / x;
  }
  const auto inverse = [&](const Vec3& w) {
    const Vec3 across = psi.cross(w);
    return Vec3(w - 0.5 * across + c * psi.cross(across));
  };
  MotionPoint<Vec3> motion{psi, inverse(rate.velocity), Vec3::Zero()};
  motion.acceleration = inverse(rate.acceleration - rotation_rate(motion).acceleration);
  return motion;
}

}  // namespace armtune::internal
