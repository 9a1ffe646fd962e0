#pragma once
// Reads a joint motion from a YAML file with a trajectory_msgs/JointTrajectory of ROS 1 or ROS 2. The file
// contains either this message alone, or a RobotTrajectory or the goal of a FollowJointTrajectory action with
// this message in it.

#include <string>

#include "core/robot/robot_model.hpp"
#include "sim/scenario/motion_points.hpp"

namespace armtune::internal {

/// Returns true if a file of that name is read as a message: its name ends with .yaml or .yml.
bool is_trajectory_message(const std::string& path);

/// Reads the message's points, in the order of the joints of this robot. Other joints in the file are
/// ignored. The time of a point is its time_from_start. If that is missing or 0 in all points, the points are
/// joint goals and there are no times. Throws InputError with file, line and key if:
///   - a joint of the robot is missing, or a joint is listed twice,
///   - there are fewer than two points,
///   - only some of the points have velocities or accelerations,
///   - a number is missing, a time is negative, or the times do not rise.
MotionPoints load_trajectory_message(const std::string& path, const RobotModel& robot);

}  // namespace armtune::internal
