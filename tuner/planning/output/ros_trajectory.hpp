#pragma once
// Converts a planned motion into a trajectory message for ROS controllers.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "tuner/planning/transcription/trajectory.hpp"

namespace armtune::internal {

enum class RosVersion { kRos1, kRos2 };

/// Returns the motion as a trajectory_msgs/JointTrajectory in YAML, for `ros2 topic pub` or `rostopic pub`.
/// Times count from the start of the motion. Numbers have a decimal point, so that readers of YAML 1.1 and
/// 1.2 take them for floating point numbers. They have all digits that are needed to read back the same
/// value. header: comment lines. One more comment line is added if the motion does not end at rest.
std::string ros_trajectory(const RobotModel& robot, const Trajectory& trajectory, RosVersion version,
                           const std::vector<std::string>& header);

}  // namespace armtune::internal
