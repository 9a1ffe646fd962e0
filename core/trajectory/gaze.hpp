#pragma once
// Computes the turn that points the tool's z axis at a target, for example a camera on the tool at an object.
// This pointing is called the gaze (equation 7 in NOTATION.md). Of all such turns it is the shortest one,
// which leaves the roll about z unchanged.

#include "core/trajectory/rotation.hpp"

namespace armtune::internal {

/// Returns the rotation vector [rad, base frame] of the shortest turn of the tool's z axis onto the line from
/// tool to target. If the target is exactly behind the tool, the turn is about the tool's x axis. If the
/// target is at the tool's origin, the turn is zero.
inline Vec3 gaze_turn(const Mat3& R_0T, const Vec3& p_0T, const Vec3& p_0G) {
  const Vec3 line = p_0G - p_0T;
  const double distance = line.norm();
  if (!(distance > 0.0)) return Vec3::Zero();
  const Vec3 u = line / distance;
  const Vec3 z = R_0T.col(2);
  const Vec3 axis = z.cross(u);
  const double sine = axis.norm();
  const double cosine = z.dot(u);
  if (sine < 1e-12) return cosine > 0.0 ? axis : Vec3(R_0T.col(0) * M_PI);
  return axis * (std::atan2(sine, cosine) / sine);
}

/// Returns the angle between the tool's z axis and the line to the target [rad].
inline double gaze_angle(const Mat3& R_0T, const Vec3& p_0T, const Vec3& p_0G) {
  return gaze_turn(R_0T, p_0T, p_0G).norm();
}

/// Returns the angular velocity [rad/s] of the line from tool to target, without roll. It is u x u', where u
/// is the unit vector along the line.
inline Vec3 gaze_line_rate(const Vec3& p_0T, const Vec3& v_0T, const Vec3& p_0G, const Vec3& v_0G) {
  const Vec3 line = p_0G - p_0T;
  const double squared = line.squaredNorm();
  if (!(squared > 0.0)) return Vec3::Zero();
  return line.cross(v_0G - v_0T) / squared;
}

}  // namespace armtune::internal
