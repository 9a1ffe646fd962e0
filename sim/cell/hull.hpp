#pragma once
// Computes the convex hull of points, such as the corners of a link's mesh, with the library Qhull (Barber,
// Dobkin and Huhdanpaa, The Quickhull algorithm for convex hulls, 1996).

#include <optional>
#include <span>

#include "sim/cell/solid.hpp"

namespace armtune::internal {

/// Returns the hull of the points [m], with its corners and triangles. Returns nothing if all points lie in
/// or near one plane. A point may lie outside the hull by at most 1e-6 of the extent of all points.
std::optional<Solid> convex_hull(std::span<const Vec3> points);

}  // namespace armtune::internal
