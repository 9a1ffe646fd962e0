#pragma once
// The distance of two convex bodies by Wolfe's algorithm (Finding the nearest point in a polytope, 1976). It
// finds the point of least norm in the difference of both bodies, and needs only their extreme points.
//
// The result is proven to a nanometre: the plane perpendicular to the line between the points found separates
// the bodies by that distance. If this precision is not reached, the proven lower bound is returned.

#include "sim/cell/solid.hpp"

namespace armtune::internal {

struct Closest {
  /// Distance of the surfaces [m], to 1e-9 m; negative where the bodies overlap. The depth of the overlap is
  /// known as long as their cores are apart. Where the cores touch, the distance is minus the sum of both
  /// radii, and the overlap is at least that deep. For two bodies without a radius it is then minus 1e-9 m.
  double distance = 0.0;
  Vec3 on_a =
      Vec3::Zero();  ///< closest points; where the cores touch, both are between the bodies' centres [m]
  Vec3 on_b = Vec3::Zero();
  Vec3 away = Vec3::UnitZ();  ///< unit vector; if a moves along it, the distance grows by as much
};

/// Returns the distance of the solids a and b. R, p: their poses in one frame; the closest points are points
/// of that frame.
Closest closest(const Solid& a, const Mat3& R_a, const Vec3& p_a, const Solid& b, const Mat3& R_b,
                const Vec3& p_b);

}  // namespace armtune::internal
