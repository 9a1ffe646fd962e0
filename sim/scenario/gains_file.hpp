#pragma once
// Reads and writes gains as YAML. The keys are the parameter names of a ROS controller for the UR10 that was
// published in 2021. The parameter file of this published controller therefore loads unchanged.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/control/gain_fields.hpp"
#include "core/control/laws/ros_distro.hpp"

namespace armtune::internal {

/// Reads and validates bundled gains by name, or a gains file by path. The file is either in armtune's own
/// format or a ROS parameter file with joint trajectory controllers (sim/controller_files).
///
/// In armtune's format, `controller: NAME` gives the kind of controller; the default is the adaptive one. The
/// gains are at the top level, or below one key of any name (`simple_effort_ctrl` in the published file), or
/// below nested keys (the node and `ros__parameters` in ROS 2). Two groups of keys are accepted and ignored:
///   - the path of the published file (circularTrajectory*), because the scenario gives the tool's path,
///   - the parameters that ROS 2 gives every node.
///
/// node: name of the controller, needed if a ROS parameter file has several. distro: the distribution of ROS
/// whose rules its joint trajectory controller follows (ros_distro.hpp). If it is not given, it is Jazzy for
/// a ROS 2 file and Noetic for a ROS 1 file. In armtune's format, the gain jtc_distro gives it instead.
/// Throws InputError.
Gains load_gains(const std::string& name_or_path, const std::vector<std::string>& joints,
                 const std::string& relative_to = {}, const std::string& node = {},
                 std::optional<RosDistro> distro = {});

/// Returns the value of a field as text for a gains file.
std::string field_text(const Gains& gains, const GainField& field);

/// Returns the tool's path of a published file (circularTrajectory*) as keys and values in YAML, so that the
/// file can be written again with it. Throws InputError.
std::vector<std::pair<std::string, std::string>> published_path(const std::string& gains_path);

/// The YAML keys above the gains, the outermost first.
using GainsKeys = std::vector<std::string>;
inline const GainsKeys kPublishedKeys = {"simple_effort_ctrl"};
inline constexpr const char* kRos2Parameters = "ros__parameters";  ///< the last key of a ROS 2 file

/// Returns the gains as the text of a gains file. Numbers read back to the same bits, also in readers of
/// YAML 1.1 and in readers that distinguish 5 from 5.0, such as ROS. header: comment lines without '#'.
/// others: further keys and their values in YAML, which are written after the gains. If `keys` contains
/// `ros__parameters`, a list of lists is written as one flat list, because ROS 2 has no lists of lists.
std::string gains_yaml(const Gains& gains, const std::vector<std::string>& header,
                       const GainsKeys& keys = kPublishedKeys,
                       const std::vector<std::pair<std::string, std::string>>& others = {});

}  // namespace armtune::internal
