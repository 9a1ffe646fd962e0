#pragma once
// Controllers in a ROS parameter file, as it lies in a package: of ROS 1 or ROS 2, among other nodes, with
// anchors and comments.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/yaml/placed_value.hpp"

namespace armtune::internal {

/// A controller with PID gains for each joint.
struct RosController {
  std::string name;  ///< as its node is called: "arm_controller", "/left/arm_controller"
  std::string
      type;  ///< "joint_trajectory_controller/JointTrajectoryController"; empty: the file does not say
  bool ros2 = false;
  yaml::Placed parameters;  ///< the map that `gains` stands in
  yaml::Placed all;         ///< of the file
};

/// Whether a text may hold some: it has a key `gains`.
bool may_hold_controllers(std::string_view text);

/// Every one of the file, in its order. Throws InputError if the text is not YAML.
std::vector<RosController> ros_controllers(const std::string& text, const std::string& file);

/// The one of that name, or without a name the only joint trajectory controller of the file. Throws
/// InputError that lists those there are.
RosController chosen_controller(const std::vector<RosController>& all, const std::string& file,
                                const std::string& name = {});

bool is_joint_trajectory_controller(const RosController& controller);

}  // namespace armtune::internal
