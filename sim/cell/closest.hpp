#pragma once
// Computes the distance between two convex bodies by Wolfe's algorithm (Finding the nearest point in a
// polytope, 1976). The algorithm finds the point of least norm in the Minkowski difference of the two bodies.
// It needs only the extreme point of each body in a given direction.
//
// The result is proven to be accurate to 1 nm. The proof is a pair of parallel planes between the bodies,
// which are perpendicular to the line between the closest points: the distance of the planes is a lower bound
// of the distance of the bodies. If the iteration ends without this accuracy, the lower bound is returned.

#include "sim/cell/solid.hpp"

namespace armtune::internal {

struct Closest {
  /// Distance between the surfaces [m], to 1e-9 m; negative if the bodies overlap. If the cores of the bodies
  /// (see Solid) do not touch, a negative distance is the depth of the overlap. If the cores touch, the
  /// distance is minus the sum of both radii, or -1e-9 m if both radii are 0. The overlap is then at least
  /// that deep.
  double distance = 0.0;
  Vec3 on_a =
      Vec3::Zero();  ///< closest points; if the cores touch, both are midway between the two origins [m]
  Vec3 on_b = Vec3::Zero();
  Vec3 away = Vec3::UnitZ();  ///< unit vector; if a moves by s along it, the distance grows by s
};

/// Returns the distance between the solids a and b. R_a, p_a, R_b, p_b: poses of the solids in one frame. The
/// closest points are given in the same frame.
Closest closest(const Solid& a, const Mat3& R_a, const Vec3& p_a, const Solid& b, const Mat3& R_b,
                const Vec3& p_b);

}  // namespace armtune::internal
