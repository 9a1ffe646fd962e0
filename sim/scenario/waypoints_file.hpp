#pragma once
// Waypoints as CSV: time [s], x, y, z [m, base frame] of a point; of a tool's poses the quaternion qw, qx,
// qy, qz beside them, or alone. Commas, semicolons, tabs or blanks separate the cells; names may have
// capitals. Other units, and columns without a line of names, are said where the file is named.

#include "core/trajectory/position_spline.hpp"
#include "core/trajectory/tool_orientation.hpp"
#include "sim/scenario/user_table.hpp"

namespace armtune::internal {

/// A path from the folder of the file that names it, or {file, units: {time, length}, columns: [time, x,
/// ...]}. Throws InputError with file, line and key.
UserTable read_waypoints_node(const yaml::Node& node);

/// The cubic spline through x, y, z, at rest before its beginning and after its end, where its acceleration
/// jumps. of_poses: qw, qx, qy, qz may stand beside them. Throws InputError naming file, line and column.
PositionSpline load_waypoints(const UserTable& waypoints, bool of_poses);

/// The turn through qw, qx, qy, qz (turning_through); x, y, z may stand beside them. Throws InputError naming
/// file, line and column.
ToolOrientation load_orientations(const UserTable& waypoints);

}  // namespace armtune::internal
