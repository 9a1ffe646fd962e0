#include "sim/cell/solid.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Returns points in S whose convex hull contains the core of the solid.
std::vector<Vec3> enclosing_points(const Solid& solid) {
  const Vec3& s = solid.size;
  switch (solid.kind) {
    case SolidKind::kSphere:
      return {Vec3::Zero()};
    case SolidKind::kCapsule:
      return {Vec3(0.0, 0.0, 0.5 * s[0]), Vec3(0.0, 0.0, -0.5 * s[0])};
    case SolidKind::kHull:
      return solid.corners;
    default:
      break;
  }
  const Vec3 half = solid.kind == SolidKind::kBox ? Vec3(0.5 * s) : Vec3(s[0], s[0], 0.5 * s[1]);
  std::vector<Vec3> corners;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) corners.push_back(half.cwiseProduct(Vec3(x, y, z)));
    }
  }
  return corners;
}

}  // namespace

Solid sphere(double radius) {
  return {SolidKind::kSphere, radius, Vec3::Zero(), {}, {}};
}
Solid capsule(double radius, double length) {
  return {SolidKind::kCapsule, radius, Vec3(length, 0.0, 0.0), {}, {}};
}
Solid box(const Vec3& edges) {
  return {SolidKind::kBox, 0.0, edges, {}, {}};
}
Solid cylinder(double radius, double length) {
  return {SolidKind::kCylinder, 0.0, Vec3(radius, length, 0.0), {}, {}};
}

Vec3 extreme_of_core(const Solid& solid, const Vec3& d) {
  const Vec3& s = solid.size;
  switch (solid.kind) {
    case SolidKind::kSphere:
      return Vec3::Zero();
    case SolidKind::kCapsule:
      return {0.0, 0.0, std::copysign(0.5 * s[0], d.z())};
    case SolidKind::kBox:
      return {std::copysign(0.5 * s[0], d.x()), std::copysign(0.5 * s[1], d.y()),
              std::copysign(0.5 * s[2], d.z())};
    case SolidKind::kCylinder: {
      const double across = std::hypot(d.x(), d.y());
      const double share = across > 0.0 ? s[0] / across : 0.0;
      return {share * d.x(), share * d.y(), std::copysign(0.5 * s[1], d.z())};
    }
    case SolidKind::kHull:
      break;
  }
  const Vec3* best = &solid.corners.front();
  double most = d.dot(*best);
  for (const Vec3& corner : solid.corners) {
    const double along = d.dot(corner);
    if (along <= most) continue;
    most = along;
    best = &corner;
  }
  return *best;
}

double farthest(const PlacedSolid& placed, const Vec3& point) {
  double most = 0.0;
  for (const Vec3& p : enclosing_points(placed.solid))
    most = std::max(most, (placed.p_BS + placed.R_BS * p - point).norm());
  return most + placed.solid.radius;
}

double farthest_from_z(const PlacedSolid& placed) {
  double most = 0.0;
  for (const Vec3& p : enclosing_points(placed.solid)) {
    const Vec3 in_B = placed.p_BS + placed.R_BS * p;
    most = std::max(most, std::hypot(in_B.x(), in_B.y()));
  }
  return most + placed.solid.radius;
}

}  // namespace armtune::internal
