#pragma once
// The distance of two convex bodies: Wolfe's algorithm (Finding the nearest point in a polytope, 1976) for
// the point of least norm in the difference of both, which it knows by their extreme points alone.
//
// It ends with a proof: the plane across the line between the points found separates the bodies by as much,
// to a nanometre. Where it does not come so far, the distance is what was proven.

#include "sim/cell/solid.hpp"

namespace armtune::internal {

struct Closest {
  /// Of the surfaces [m], to 1e-9 m; negative where the bodies meet. How deep they meet is known as long as
  /// their cores are apart; where cores meet, it is minus the sum of both radii, and at least that deep. Of
  /// two bodies without a radius that is minus 1e-9 m.
  double distance = 0.0;
  Vec3 on_a =
      Vec3::Zero();  ///< the closest points; where cores meet, both are between the bodies' centres [m]
  Vec3 on_b = Vec3::Zero();
  Vec3 away = Vec3::UnitZ();  ///< unit vector: where a moves along it, the distance grows as much
};

/// R, p: the poses of both solids in one frame; the closest points are points of that frame.
Closest closest(const Solid& a, const Mat3& R_a, const Vec3& p_a, const Solid& b, const Mat3& R_b,
                const Vec3& p_b);

}  // namespace armtune::internal
