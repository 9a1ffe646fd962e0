#pragma once
// Gains in YAML, field for field the published names, so that a ROS parameter file of such a controller loads
// as it is.

#include <string>
#include <utility>
#include <vector>

#include "core/control/gain_fields.hpp"

namespace armtune::internal {

/// Reads bundled gains by name, or a file by path: armtune's own, or a ROS parameter file with one joint
/// trajectory controller (sim/controller_files). `controller: NAME` says whose they are; without it they
/// are the adaptive one's. The fields stand at the top or under one key of any name (the published
/// `simple_effort_ctrl`), or one below another (ROS 2's node and `ros__parameters`). The path of the
/// published file (circularTrajectory*) is accepted and not used: the scenario says where the tool goes; so
/// are the parameters that ROS 2 gives every node. node: which controller of a ROS parameter file that has
/// several. Validated. Throws InputError.
Gains load_gains(const std::string& name_or_path, const std::vector<std::string>& joints,
                 const std::string& relative_to = {}, const std::string& node = {});

/// A field's value as it stands in such a file.
std::string field_text(const Gains& gains, const GainField& field);

/// What the published file says of the tool's path (circularTrajectory*), as it stands there: key and value
/// in YAML, for whoever writes such a file again. Throws InputError.
std::vector<std::pair<std::string, std::string>> published_path(const std::string& gains_path);

/// The YAML keys that gains stand under, the outermost first.
using GainsKeys = std::vector<std::string>;
inline const GainsKeys kPublishedKeys = {"simple_effort_ctrl"};
inline constexpr const char* kRos2Parameters = "ros__parameters";  ///< the last key of a ROS 2 file

/// The gains as such a file; numbers read back to the same bits, also by readers of YAML 1.1 and those that
/// tell 5 from 5.0, as ROS has them. `header`: comment lines without '#'. `others`: keys with values in YAML,
/// to follow the gains. Below the key `ros__parameters` no list is in a list.
std::string gains_yaml(const Gains& gains, const std::vector<std::string>& header,
                       const GainsKeys& keys = kPublishedKeys,
                       const std::vector<std::pair<std::string, std::string>>& others = {});

}  // namespace armtune::internal
