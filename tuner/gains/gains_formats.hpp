#pragma once
// Writes gains in the file formats that robots read.

#include <string>
#include <utility>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune::internal {

enum class GainsFormat {
  kYaml,  ///< armtune's own format (gains_file.hpp)
  kRos1,  ///< parameter file for rosparam load
  kRos2   ///< parameter file for --params-file, with the keys NODE and ros__parameters
};

/// Returns the formats' names on the command line, in the order above.
const std::vector<std::string>& gains_format_names();
/// Returns the format with this name. Throws InputError that lists the formats if the name is unknown.
GainsFormat gains_format_from_name(const std::string& name);

struct GainsFile {
  Gains gains;
  std::vector<std::string> joints;  ///< names, in the order of joint vectors
  /// Origin of the gains: pairs of a key and its value in words.
  std::vector<std::pair<std::string, std::string>> origin;
  /// Further keys of a robot's parameter file that are not gains, with their values in YAML.
  std::vector<std::pair<std::string, std::string>> others;
  /// Name space or node of the controller. If it is empty, a ROS 2 file applies to every node, and other
  /// files have the name space simple_effort_ctrl.
  std::string node;
};

/// Returns the text of the file. Comments at its top give the origin, and the order of task-space and joint
/// numbers. Comments above each field give its unit and meaning. Numbers have all digits that are needed to
/// read back the same value. Throws InputError if the name of the node is not valid in ROS.
std::string gains_text(const GainsFile& file, GainsFormat format);

}  // namespace armtune::internal
