#pragma once
// Extreme points of convex bodies, written out.

#include <cmath>

#include "sim/cell/solid.hpp"

namespace armtune::internal::test {

/// A point of the solid that lies farthest along d, in the frame that R, p place the solid in.
inline Vec3 extreme_point(const Solid& solid, const Mat3& R, const Vec3& p, const Vec3& d) {
  const Vec3 local = R.transpose() * d;
  const auto sign = [](double x) { return x < 0.0 ? -1.0 : 1.0; };
  const Vec3& s = solid.size;
  Vec3 x = Vec3::Zero();
  if (solid.kind == SolidKind::kCapsule) x.z() = 0.5 * s[0] * sign(local.z());
  if (solid.kind == SolidKind::kBox)
    x = 0.5 * Vec3(s[0] * sign(local.x()), s[1] * sign(local.y()), s[2] * sign(local.z()));
  if (solid.kind == SolidKind::kCylinder) {
    const double across = std::hypot(local.x(), local.y());
    if (across > 0.0) x = Vec3(s[0] * local.x() / across, s[0] * local.y() / across, 0.0);
    x.z() = 0.5 * s[1] * sign(local.z());
  }
  if (solid.kind == SolidKind::kHull) {
    x = solid.corners.front();
    for (const Vec3& corner : solid.corners) {
      if (corner.dot(local) > x.dot(local)) x = corner;
    }
  }
  return p + R * (x + solid.radius * local.normalized());
}

}  // namespace armtune::internal::test
