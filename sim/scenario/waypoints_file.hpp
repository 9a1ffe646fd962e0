#pragma once
// Waypoints as CSV: time [s], x, y, z [m, base frame] of a point. For a tool's poses, the quaternion qw, qx,
// qy, qz is beside them, or alone. Cells are separated by commas, semicolons, tabs or blanks, and names may
// have capitals. Other units, and the columns of a file without column names, are declared where the file is
// named.

#include "core/trajectory/position_spline.hpp"
#include "core/trajectory/tool_orientation.hpp"
#include "sim/scenario/user_table.hpp"

namespace armtune::internal {

/// Reads a path, relative to the folder of the file that names it, or {file, units: {time, length}, columns:
/// [time, x, ...]}. Throws InputError with file, line and key.
UserTable read_waypoints_node(const yaml::Node& node);

/// Reads the cubic spline through x, y, z. It is at rest before its beginning and after its end, where its
/// acceleration jumps. of_poses: qw, qx, qy, qz may be beside them. Throws InputError naming file, line and
/// column.
PositionSpline load_waypoints(const UserTable& waypoints, bool of_poses);

/// Reads the rotation through qw, qx, qy, qz (turning_through). x, y, z may be beside them. Throws InputError
/// naming file, line and column.
ToolOrientation load_orientations(const UserTable& waypoints);

}  // namespace armtune::internal
