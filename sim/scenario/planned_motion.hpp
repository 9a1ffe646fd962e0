#pragma once
// Reads a planned joint trajectory from a file: the CSV that `armtune plan` writes, a user's CSV with the
// same columns, or a trajectory message of ROS.

#include <optional>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "core/trajectory/joint_spline.hpp"
#include "sim/scenario/user_table.hpp"

namespace armtune::internal {

/// The motion between the points of a file.
enum class Segments {
  kOfFile,    ///< depends on the file, see load_planned_motion
  kAsRos,     ///< interpolated as in the controllers of ROS (ros_segments.hpp)
  kNextPoint  ///< not interpolated, as in such controllers with interpolation_method `none`
};

/// A file with a planned motion, and how its points are interpolated.
struct PlannedFile {
  UserTable table;
  Segments segments = Segments::kOfFile;
  double speed = 1.0;  ///< factor on the speed; 0.5 doubles the time after the first point
};

/// Reads a node that names the file of a planned motion: the file's name alone, or a map {file, units: {time,
/// angle, length}, columns: [time, JOINT, ...], segments: as_ros or next_point, speed}. A relative name
/// begins in the folder of the file that contains the node. Throws InputError with file, line and key.
PlannedFile read_planned_node(const yaml::Node& node);

/// Reads a planned motion from a CSV file or a trajectory message.
///
/// A CSV file has the column `time` [s] and, for each joint of the robot, `joint/NAME/position` or simply
/// `NAME`. It may also have `joint/NAME/velocity` for all joints, and then `joint/NAME/acceleration` for all
/// joints. Velocities and accelerations are per second, even if `time` has another unit. Other columns are
/// ignored.
///
/// With `segments: next_point`, which requires velocities, the motion jumps from point to point
/// (JointSpline). Otherwise the points are interpolated in one of these ways:
///   - as ROS does, if the file is a message, has velocities but no accelerations, or has `segments: as_ros`;
///   - otherwise, with linear acceleration between rows, if the file has accelerations;
///   - otherwise, by the cubic spline through the positions, which is at rest at both ends.
///
/// Throws InputError with file, line, column, value and limit if:
///   - a column or a number is missing,
///   - the first time is negative, or the times do not rise,
///   - a joint leaves its position limits at a point or between two points,
///   - the position or velocity of a row does not match the accelerations of this row and the row before it.
JointSpline load_planned_motion(const PlannedFile& file, const RobotModel& robot);

/// The content of a file: a motion, or joint goals, which are positions without times.
struct MotionOrGoals {
  std::optional<JointSpline> motion;
  std::vector<JointVector> goals;  ///< n each, in joint order [rad, m]; empty if the file gives a motion
};

/// The largest number of goals that a file may give.
inline constexpr std::size_t kMostGoals = 100;

/// Reads a planned motion, as load_planned_motion does, or joint goals. A CSV file with goals has a column
/// with the positions of each joint, and no other columns. A message has goals if time_from_start is missing
/// or 0 in all of its points. Throws InputError with file and line also if there are fewer than two goals or
/// more than kMostGoals.
MotionOrGoals load_motion_or_goals(const PlannedFile& file, const RobotModel& robot);

}  // namespace armtune::internal
