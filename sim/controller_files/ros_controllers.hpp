#pragma once
// Finds the controllers whose gains can be tuned in a parameter file of ROS 1 or ROS 2. The file of a ROS
// package can be used unchanged: it may also contain other nodes, YAML anchors and comments.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/control/laws/ros_distro.hpp"
#include "sim/yaml/placed_value.hpp"

namespace armtune::internal {

/// How a file gives the gains of a controller.
enum class GainLayout {
  kPidByJoint,  ///< a map `gains` with p, i and d of each joint
  kImpedance,   ///< lists k_gains and d_gains, as in the joint impedance examples for Franka's arms
  kMapped       ///< numbers anywhere in the file, which the user binds to gains (gain_map.hpp)
};

/// A place in a file that the user binds to a gain.
struct GainPlace {
  std::string path;     ///< keys from the outermost one, joined by '/'; items of lists count from 0
  std::string gain;     ///< "joint_impedance_k" for a list, "joint_impedance_k/elbow" for one number
  double factor = 1.0;  ///< the gain is this factor times the number in the file
};

/// A controller with gains for each joint.
struct RosController {
  std::string name;  ///< name of its node: "arm_controller", "/left/arm_controller"
  std::string type;  ///< "joint_trajectory_controller/JointTrajectoryController"; empty: not in the file
  bool ros2 = false;
  std::optional<RosDistro> distro = {};  ///< whose rules a joint trajectory controller follows, if given
  GainLayout layout = GainLayout::kPidByJoint;
  yaml::Placed parameters;  ///< the map that contains the gains
  yaml::Placed all;         ///< the whole file
  /// Names of the file's other controllers, broadcasters included, whether they have gains or not.
  std::vector<std::string> neighbours = {};
  // The rest is for kMapped only.
  std::string map_file = {};           ///< file of the map
  std::string kind = {};               ///< armtune's controller
  std::vector<GainPlace> places = {};  ///< of the gains
  double rate = 0.0;                   ///< control rate that the map gives [Hz]; 0: none
  std::vector<std::pair<std::string, std::vector<double>>> others =
      {};  ///< gains that the file does not have
};

/// Returns true if a text may contain controllers, because it has a key `gains`, `gains.*` or `k_gains`.
bool may_hold_controllers(std::string_view text);

/// Returns true if a text may be a map of gains (gain_map.hpp), because it has the keys `controller`, `file`
/// and `map`.
bool may_hold_map(std::string_view text);

/// Returns all controllers of the file, in its order: those of ROS 2, with the parameters that wildcards give
/// them (ros_nodes.hpp), then those of ROS 1. Throws InputError if the text is not YAML.
std::vector<RosController> ros_controllers(const std::string& text, const std::string& file);

/// Returns the joint trajectory controllers of the file that have no gains.
std::vector<RosController> controllers_without_gains(const yaml::Placed& root, const std::string& file);

/// Throws InputError that says why no controller of the file can be tuned, and what can be done. name: of the
/// controller that was asked for; empty: none.
[[noreturn]] void refuse_file_without_gains(const yaml::Placed& root, const std::string& file,
                                            const std::string& name);

/// Returns the controller of that name. Without a name, returns the only joint trajectory controller of the
/// file that armtune can simulate. If there is none, returns the only joint impedance controller that armtune
/// can simulate. If `joints`, the names of the arm's joints, is not empty, controllers without gains for
/// these joints are left out. Throws InputError if no controller or more than one remains. The message lists
/// the controllers.
RosController chosen_controller(const std::vector<RosController>& all, const std::string& file,
                                const std::string& name = {}, const std::vector<std::string>& joints = {});

}  // namespace armtune::internal
