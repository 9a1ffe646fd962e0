#pragma once
// The convex hull of points, by the library Qhull (Barber, Dobkin and Huhdanpaa, The Quickhull algorithm for
// convex hulls, 1996).

#include <optional>
#include <span>

#include "sim/cell/solid.hpp"

namespace armtune::internal {

/// Returns the hull of the points [m], with its corners and triangles; nothing if they lie in a plane, or
/// close to one. It contains every point to within 1e-6 of their extent.
std::optional<Solid> convex_hull(std::span<const Vec3> points);

}  // namespace armtune::internal
