#pragma once
// Reads a planned joint trajectory from a file: the CSV that `armtune plan` writes, a user's CSV with the
// same columns, or a trajectory message of ROS.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/trajectory/joint_spline.hpp"
#include "sim/scenario/user_table.hpp"

namespace armtune::internal {

/// A file with a planned motion, and how its points are interpolated.
struct PlannedFile {
  UserTable table;
  bool as_ros = false;  ///< true: as in the controllers of ROS, see ros_segments.hpp
};

/// Reads a path, relative to the folder of the file that names it, or {file, units: {time, angle, length},
/// columns: [time, JOINT, ...], segments: as_ros}. Throws InputError with file, line and key.
PlannedFile read_planned_node(const yaml::Node& node);

/// Reads a planned motion from a CSV file or a trajectory message.
///
/// A CSV file has `time` [s] and, for each joint of the robot, `joint/NAME/position` or simply `NAME`. All or
/// none of the joints have `joint/NAME/velocity` and `/acceleration` (rad or m; per second, whatever the unit
/// of time). Other columns are ignored. Points are interpolated as follows:
///   - as ROS does: a message, rows with velocities and no accelerations, and with `segments: as_ros`;
///   - otherwise, with accelerations: linear acceleration between rows;
///   - otherwise, positions alone: the cubic spline, at rest at both ends.
///
/// Throws InputError with file, line, column, value and limit if a column or a number is missing, times do
/// not rise from 0 s on, a position is outside the joint's limits, or the position or velocity of a row does
/// not match the accelerations of this row and the row before it.
JointSpline load_planned_motion(const PlannedFile& file, const RobotModel& robot);

}  // namespace armtune::internal
