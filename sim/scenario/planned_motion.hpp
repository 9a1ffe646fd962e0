#pragma once
// A planned trajectory as a file: the CSV that `armtune plan` writes, or one with the same columns.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/trajectory/joint_spline.hpp"

namespace armtune::internal {

/// Reads `time` [s] and, for each joint of the robot, `joint/NAME/position`, `/velocity` and `/acceleration`
/// (rad or m); other columns do not count. Between rows the acceleration is linear; of waypoints, a file with
/// positions alone, it is that of the cubic spline through them, at rest at both ends. Throws InputError with
/// file, line, column, value and limit if a column or a number is missing, times do not rise from 0 s on, a
/// position is outside the joint's limits, or a row is not where the acceleration takes the row before it.
JointSpline load_planned_motion(const std::string& path, const RobotModel& robot);

}  // namespace armtune::internal
