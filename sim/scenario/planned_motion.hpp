#pragma once
// A planned trajectory as a file: the CSV that `armtune plan` writes, one of a user's with the same columns,
// or a trajectory message of ROS.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/trajectory/joint_spline.hpp"
#include "sim/scenario/user_table.hpp"

namespace armtune::internal {

/// A file, and how its points are joined.
struct PlannedFile {
  UserTable table;
  bool as_ros = false;  ///< as ROS's controllers do: see ros_segments.hpp
};

/// Reads a path from the folder of the file that names it, or {file, units: {time, angle, length}, columns:
/// [time, JOINT, ...], segments: as_ros}. Throws InputError with file, line and key.
PlannedFile read_planned_node(const yaml::Node& node);

/// Reads a CSV file's `time` [s] and, for each joint of the robot, `joint/NAME/position` or simply `NAME`,
/// and of all or none `joint/NAME/velocity` and `/acceleration` (rad or m; per second, whatever the unit of
/// time); other columns do not count. Or a trajectory message, whose points are joined as ROS does, as are
/// rows with velocities and without accelerations. Unless rows are to be joined so: with accelerations, these
/// are linear between rows; positions alone are joined by the cubic spline, at rest at both ends. Throws
/// InputError with file, line, column, value and limit if a column or a number is missing, times do not rise
/// from 0 s on, a position is outside the joint's limits, or a row is not where the acceleration takes the
/// row before it.
JointSpline load_planned_motion(const PlannedFile& file, const RobotModel& robot);

}  // namespace armtune::internal
