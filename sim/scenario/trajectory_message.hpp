#pragma once
// A trajectory_msgs/JointTrajectory of ROS 1 or ROS 2 as YAML: alone, or within a RobotTrajectory, or within
// the goal of a FollowJointTrajectory.

#include <string>

#include "core/robot/robot_model.hpp"
#include "sim/scenario/motion_points.hpp"

namespace armtune::internal {

/// Whether a file of that name is read as a message: it ends with .yaml or .yml.
bool is_trajectory_message(const std::string& path);

/// Its points, for the joints of this robot in the order of the robot; what it has of other joints does not
/// count. Time is time_from_start. Throws InputError with file, line and key if a joint of the robot is
/// missing, points differ in what they give, a number is missing, or times do not rise.
MotionPoints load_trajectory_message(const std::string& path, const RobotModel& robot);

}  // namespace armtune::internal
