#pragma once
// A planned motion as a trajectory that ROS controllers take.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "tuner/planning/transcription/trajectory.hpp"

namespace armtune::internal {

enum class RosVersion { kRos1, kRos2 };

/// trajectory_msgs/JointTrajectory as YAML, for `ros2 topic pub` or `rostopic pub`: times from its own start.
/// Numbers are floating point ones for readers of YAML 1.1 and 1.2 alike, and read back to the same bits.
/// header: comment lines; one is added where the motion does not end at rest.
std::string ros_trajectory(const RobotModel& robot, const Trajectory& trajectory, RosVersion version,
                           const std::vector<std::string>& header);

}  // namespace armtune::internal
