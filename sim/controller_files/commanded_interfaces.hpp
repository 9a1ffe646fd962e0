#pragma once
// Reads which quantities a ROS joint_trajectory_controller commands: efforts, velocities or others.

#include <string>
#include <vector>

#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns the command interfaces, such as "effort". In ROS 1 the type of the controller determines them; for
/// a type of an unknown package, this returns the type. Empty: the file does not give them.
std::vector<std::string> commanded_interfaces(const RosController& controller);

/// Returns true if armtune simulates these command interfaces: efforts alone or velocities alone. In ROS 1
/// also true if the file does not give them; they are then taken for efforts.
bool are_simulated(const std::vector<std::string>& interfaces, bool ros2);

}  // namespace armtune::internal
