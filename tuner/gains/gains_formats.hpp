#pragma once
// Gains in the forms that robots read.

#include <string>
#include <utility>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune::internal {

enum class GainsFormat {
  kYaml,  ///< armtune's own, which is the published form
  kRos1,  ///< a parameter file for rosparam load
  kRos2   ///< a parameter file for --params-file: NODE: ros__parameters:
};

/// The names on the command line, in the order above.
const std::vector<std::string>& gains_format_names();
/// Throws InputError naming those there are.
GainsFormat gains_format_from_name(const std::string& name);

struct GainsFile {
  Gains gains;
  std::vector<std::string> joints;  ///< names, in the order of joint vectors
  /// Where they came from: what, and that in words.
  std::vector<std::pair<std::string, std::string>> origin;
  /// Keys with values in YAML that are no gains, and that a robot's parameter file has too.
  std::vector<std::pair<std::string, std::string>> others;
  /// The controller's name space or node; empty: the published one, of ROS 2 every node.
  std::string node;
};

/// The file's text. The origin and the order of six-vectors stand in comments at the top, unit and meaning
/// above each field. Numbers read back to the same bits. Throws InputError if the node's name is none that
/// ROS takes.
std::string gains_text(const GainsFile& file, GainsFormat format);

}  // namespace armtune::internal
