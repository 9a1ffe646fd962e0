#pragma once
// Waypoints of a point as CSV: columns time [s], x, y, z [m, base frame].

#include <string>

#include "core/trajectory/position_spline.hpp"

namespace armtune {

/// The cubic spline through them, at rest before its beginning and after its end, where its acceleration
/// jumps. Throws InputError naming file, line and column.
PositionSpline load_waypoints(const std::string& path);

}  // namespace armtune
