#pragma once
// Reads the waypoints of a path from a user's CSV file, with the columns time [s], x, y, z [m, base frame].
// Waypoints of a tool may have an orientation, as a quaternion in the columns qw, qx, qy, qz. These columns
// can replace the position or be added to it. Cells are separated by commas, semicolons, tabs or blanks, and
// column names may be in upper or lower case. A scenario that refers to the file can declare other units, and
// the names of the columns.

#include "core/robot/robot_model.hpp"
#include "core/trajectory/position_spline.hpp"
#include "core/trajectory/tool_orientation.hpp"
#include "sim/scenario/user_table.hpp"

namespace armtune::internal {

/// Reads a node that names a file of waypoints: the file's name alone, or a map {file, units: {time, length},
/// columns: [time, x, ...]}. A relative name begins in the folder of the file that contains the node. Throws
/// InputError with file, line and key.
UserTable read_waypoints_node(const yaml::Node& node);

/// Returns true if the file is a table with the columns x, y and z, and none of them is a joint of the robot.
/// Returns false too if the file cannot be read as a table.
bool has_tool_waypoints(const UserTable& file, const RobotModel& robot);

/// Returns true if the file has the columns of an orientation. Throws InputError as load_waypoints does.
bool has_orientations(const UserTable& waypoints);

/// Reads the positions and returns the cubic spline through them. The motion is at rest before the first and
/// after the last waypoint; its acceleration jumps at both. of_poses: true if the file may also have the
/// columns of an orientation. Throws InputError naming file, line and column.
PositionSpline load_waypoints(const UserTable& waypoints, bool of_poses);

/// Reads the orientations and returns the rotation through them (turning_through). The file may also have the
/// columns x, y, z. Throws InputError naming file, line and column.
ToolOrientation load_orientations(const UserTable& waypoints);

}  // namespace armtune::internal
