#pragma once
// Represents a convex body (sphere, capsule, box, cylinder or convex hull) for the computation of distances.
// Links, tools and the parts of a robot cell consist of such bodies.

#include <vector>

#include "core/common/types.hpp"

namespace armtune::internal {

enum class SolidKind { kSphere, kCapsule, kBox, kCylinder, kHull };

/// A convex body about the origin of its own frame S. It consists of all points within `radius` of its core.
/// The core of a capsule is a line and that of a sphere a point. A box, a cylinder and a hull are their own
/// core and have a radius of 0.
struct Solid {
  SolidKind kind = SolidKind::kSphere;
  double radius = 0.0;  ///< of a sphere or a capsule about its core [m]; 0 for the others
  Vec3 size =
      Vec3::Zero();  ///< box: edge lengths; capsule: (line length, 0, 0); cylinder: (radius, length, 0) [m]
  std::vector<Vec3> corners;                  ///< of a hull [m]
  std::vector<std::array<int, 3>> triangles;  ///< of a hull: corner indices, counter-clockwise from outside
};

/// Returns a sphere about the origin. Here and below, all lengths must be positive [m].
Solid sphere(double radius);
/// Returns a capsule along z; `length` is without its caps.
Solid capsule(double radius, double length);
Solid box(const Vec3& edges);
/// Returns a cylinder along z.
Solid cylinder(double radius, double length);

/// Returns a point of the solid's core that lies farthest in the direction d. d: vector in S, not zero.
Vec3 extreme_of_core(const Solid& solid, const Vec3& d);

/// Returns the largest d . x over the points x of the solid. d: unit vector in S.
inline double support(const Solid& solid, const Vec3& d) {
  return d.dot(extreme_of_core(solid, d)) + solid.radius;
}

/// A solid with its pose in some frame B.
struct PlacedSolid {
  Solid solid;
  Mat3 R_BS = Mat3::Identity();
  Vec3 p_BS = Vec3::Zero();  ///< [m]
};

/// Returns the largest distance between `point` and any point of the placed solid [m]. point: in frame B. For
/// a cylinder this is an upper bound, namely the result for the box around the cylinder.
double farthest(const PlacedSolid& placed, const Vec3& point);

/// Returns the largest distance between the z axis of B and any point of the placed solid [m]. For a cylinder
/// this is an upper bound as above.
double farthest_from_z(const PlacedSolid& placed);

}  // namespace armtune::internal
