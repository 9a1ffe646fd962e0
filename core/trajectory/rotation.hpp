#pragma once
// Converts rotation vectors to rotations and back (exponential and logarithm). A rotation vector is the axis
// times the full angle of the turn.

#include <Eigen/Geometry>
#include <cmath>

#include "core/common/types.hpp"

namespace armtune::internal {

/// Returns the rotation by |phi| [rad] about phi.
inline Eigen::Quaterniond rotation_exp(const Vec3& phi) {
  const double angle = phi.norm();
  // sin(angle/2)/angle, by its series where the quotient loses digits.
  const double scale = angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  Eigen::Quaterniond q;
  q.w() = std::cos(0.5 * angle);
  q.vec() = scale * phi;
  return q;
}

/// Returns the rotation vector of a unit quaternion, |phi| <= pi. The sign of the quaternion does not matter.
inline Vec3 rotation_log(const Eigen::Quaterniond& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const Vec3 v = sign * q.vec();
  const double s = v.norm();
  const double w = sign * q.w();
  // angle/sin(angle/2), by its series where the quotient loses digits.
  const double scale = s < 1e-6 ? 2.0 / w : 2.0 * std::atan2(s, w) / s;
  return scale * v;
}

/// Returns the rotation vector nearest to `near` that describes the same rotation as phi. All vectors of one
/// rotation differ by whole turns. If `near` is the previous vector of a motion, the rotation can therefore
/// grow beyond half a turn without a jump of its vector.
inline Vec3 nearest_rotation_vector(const Vec3& phi, const Vec3& near) {
  const double angle = phi.norm();
  const Vec3 axis = angle > 1e-9 ? Vec3(phi / angle) : near.stableNormalized();
  return phi + 2.0 * M_PI * std::round((near.dot(axis) - angle) / (2.0 * M_PI)) * axis;
}

}  // namespace armtune::internal
