#pragma once
// Reads from a URDF which command and state interfaces ros2_control gives each joint, such as "position".

#include <map>
#include <string>
#include <vector>

namespace armtune::internal {

/// The interfaces of one joint: "position", "velocity", "effort" and any others that the file names.
struct JointInterfaces {
  std::vector<std::string> command;
  std::vector<std::string> state;
  bool operator==(const JointInterfaces& other) const {
    return command == other.command && state == other.state;
  }
};

/// Returns the interfaces of every joint in the `<ros2_control>` elements of a URDF's text, by joint name. A
/// joint that appears in several of them has the interfaces of all.
std::map<std::string, JointInterfaces> ros2_control_interfaces(const std::string& urdf);

}  // namespace armtune::internal
