#pragma once
// Computes the feed-forward for a tool whose z axis points at a moving target:
//   - the angular velocity and acceleration of the line from tool to target,
//   - the shortest turn (gaze.hpp) of a fixed frame's z axis onto that line, with exact first and second
//     derivatives.

#include "core/trajectory/gaze.hpp"
#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/rotation_rate.hpp"

namespace armtune::internal {

/// Returns the direction u of the line from tool to target, with u' and u''. The line is l = r u, so that
/// r u' = l' - r' u and r u'' = l'' - r'' u - 2 r' u'. If the target is at the tool, u is zero.
inline MotionPoint<Vec3> gaze_direction(const MotionPoint<Vec3>& tool, const MotionPoint<Vec3>& target) {
  const Vec3 line = target.position - tool.position;
  const double r = line.norm();
  if (!(r > 0.0)) return {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  const Vec3 line_dot = target.velocity - tool.velocity;
  const Vec3 line_ddot = target.acceleration - tool.acceleration;
  MotionPoint<Vec3> u;
  u.position = line / r;
  const double r_dot = u.position.dot(line_dot);
  u.velocity = (line_dot - r_dot * u.position) / r;
  const double r_ddot = u.velocity.dot(line_dot) + u.position.dot(line_ddot);
  u.acceleration = (line_ddot - r_ddot * u.position - 2.0 * r_dot * u.velocity) / r;
  return u;
}

/// Returns the turn rate of a frame that follows a unit direction without roll: w = u x u', w' = u x u''.
inline TurnRate direction_rate(const MotionPoint<Vec3>& u) {
  return {u.position.cross(u.velocity), u.position.cross(u.acceleration)};
}

/// Returns the rotation vector phi of the shortest turn of a fixed frame's z axis onto u, with phi' and
/// phi''. It is phi = g(c) a, where a = z x u, c = z . u = cos(angle) and g = angle / sin(angle). The
/// derivatives g1 and g2 of g by c follow from (1 - c^2) g1 = c g - 1 and (1 - c^2) g2 = g + 3 c g1. If u
/// points exactly along -z, phi has no derivatives, and zeros are returned for them.
inline MotionPoint<Vec3> gaze_turn_motion(const Mat3& R_0F, const MotionPoint<Vec3>& u) {
  const Vec3 z = R_0F.col(2);
  const Vec3 a = z.cross(u.position);
  const Vec3 a_dot = z.cross(u.velocity);
  const Vec3 a_ddot = z.cross(u.acceleration);
  const double c = z.dot(u.position);
  const double c_dot = z.dot(u.velocity);
  const double c_ddot = z.dot(u.acceleration);
  const double sine_squared = a.squaredNorm();
  const double sine = std::sqrt(sine_squared);
  if (sine < 1e-12 && c <= 0.0) {
    const bool none = u.position.isZero(0.0);
    return {none ? Vec3::Zero() : Vec3(R_0F.col(0) * M_PI), Vec3::Zero(), Vec3::Zero()};
  }
  double g = 1.0;
  double g1 = -1.0 / 3.0;
  double g2 = 4.0 / 15.0;
  if (c > 1.0 - 1e-4) {
    // Around c = 1 the quotients lose digits: g = 1 + x/3 + 2 x^2/15 + 2 x^3/35 + 8 x^4/315 in x = 1 - c.
    // sine^2 / (1 + c) gives x without cancellation.
    const double x = sine_squared / (1.0 + c);
    g = 1.0 + x * (1.0 / 3.0 + x * (2.0 / 15.0 + x * (2.0 / 35.0)));
    g1 = -(1.0 / 3.0 + x * (4.0 / 15.0 + x * (6.0 / 35.0 + x * (32.0 / 315.0))));
    g2 = 4.0 / 15.0 + x * (12.0 / 35.0 + x * (32.0 / 105.0));
  } else {
    g = std::atan2(sine, c) / sine;
    g1 = (c * g - 1.0) / sine_squared;
    g2 = (g + 3.0 * c * g1) / sine_squared;
  }
  MotionPoint<Vec3> phi;
  phi.position = g * a;
  phi.velocity = g1 * c_dot * a + g * a_dot;
  phi.acceleration = (g2 * c_dot * c_dot + g1 * c_ddot) * a + 2.0 * g1 * c_dot * a_dot + g * a_ddot;
  return phi;
}

}  // namespace armtune::internal
