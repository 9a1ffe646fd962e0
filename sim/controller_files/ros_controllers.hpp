#pragma once
// Finds the controllers whose gains can be tuned in a parameter file of ROS 1 or ROS 2. The file can be used
// as it is in a ROS package, with other nodes, YAML anchors and comments.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/yaml/placed_value.hpp"

namespace armtune::internal {

/// How a file gives the gains of a controller.
enum class GainLayout {
  kPidByJoint,  ///< a map `gains` with p, i and d of each joint
  kImpedance    ///< lists k_gains and d_gains, as the joint impedance examples for Franka's arms have them
};

/// A controller with gains for each joint.
struct RosController {
  std::string name;  ///< name of its node: "arm_controller", "/left/arm_controller"
  std::string type;  ///< "joint_trajectory_controller/JointTrajectoryController"; empty: not in the file
  bool ros2 = false;
  GainLayout layout = GainLayout::kPidByJoint;
  yaml::Placed parameters;  ///< the map that contains the gains
  yaml::Placed all;         ///< the whole file
};

/// Returns true if a text may contain controllers, because it has a key `gains` or `k_gains`.
bool may_hold_controllers(std::string_view text);

/// Returns all controllers of the file, in its order. Throws InputError if the text is not YAML.
std::vector<RosController> ros_controllers(const std::string& text, const std::string& file);

/// Returns the controller of that name. Without a name, returns the only joint trajectory controller of the
/// file; if it has none, the only joint impedance controller. Throws InputError if no controller or more than
/// one fits. The message lists the file's controllers.
RosController chosen_controller(const std::vector<RosController>& all, const std::string& file,
                                const std::string& name = {});

}  // namespace armtune::internal
