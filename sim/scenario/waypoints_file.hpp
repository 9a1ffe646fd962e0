#pragma once
// Waypoints as CSV: time [s], x, y, z [m, base frame] of a point; of a tool's poses the quaternion qw, qx,
// qy, qz beside them, or alone. Commas, semicolons, tabs or blanks separate the cells; names may have
// capitals.

#include <string>

#include "core/trajectory/position_spline.hpp"
#include "core/trajectory/tool_orientation.hpp"

namespace armtune::internal {

/// The cubic spline through x, y, z, at rest before its beginning and after its end, where its acceleration
/// jumps. of_poses: qw, qx, qy, qz may stand beside them. Throws InputError naming file, line and column.
PositionSpline load_waypoints(const std::string& path, bool of_poses);

/// The turn through qw, qx, qy, qz (turning_through); x, y, z may stand beside them. Throws InputError naming
/// file, line and column.
ToolOrientation load_orientations(const std::string& path);

}  // namespace armtune::internal
