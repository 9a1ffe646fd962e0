#pragma once
// Finds the parameters of each joint in the parameter file of a ROS joint_trajectory_controller.

#include <array>
#include <string>

#include "sim/controller_files/parameter_reader.hpp"

namespace armtune::internal {

/// The keys of the PID gains in a joint's map in the file. jtc_name() converts each key to armtune's name.
inline constexpr std::array kGainNames = {"p", "i", "d"};

/// Returns the name of a joint without a placeholder at its beginning, such as `${prefix}`, `$(arg prefix)`
/// or `$(var prefix)`. A launch file or xacro replaces the placeholder by a prefix.
std::string without_prefix(const std::string& key);

class JointParameters : public ParameterReader {
 public:
  using ParameterReader::ParameterReader;

  /// Returns the value of a joint at `key`, or null if the file has none.
  const yaml::PlacedValue* of_joint(const std::string& joint, const char* key) const;

  /// Returns the joint's feed-forward factor on the desired velocity, or null if there is none. In ROS 1
  /// files it is in a separate map.
  const yaml::PlacedValue* feed_forward(const std::string& joint) const;
};

}  // namespace armtune::internal
