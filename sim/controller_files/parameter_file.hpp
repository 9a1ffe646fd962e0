#pragma once
// A file that has the gains of a robot's controller: a ROS parameter file, or any YAML file to which a map
// binds gains (gain_map.hpp). Tuned gains can be written into a copy of it.

#include <optional>
#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

struct ParameterFile {
  std::string path;  ///< of the file with the numbers
  std::string text;  ///< its contents
  RosController controller;
};

/// Reads the file at `path`. If that is a map, also reads the file with the numbers that the map binds to
/// gains. node: name of the controller in a ROS parameter file; empty: the only one for an arm with these
/// joints (chosen_controller). distro: see set_distro. Returns nothing if it is neither a map nor a ROS
/// parameter file with controllers. Throws InputError if a file cannot be read, or has no such controller, or
/// if the distribution does not fit it.
std::optional<ParameterFile> read_parameter_file(const std::string& path, const std::string& node = {},
                                                 std::optional<RosDistro> distro = {},
                                                 const std::vector<std::string>& joints = {});

/// Does the same, but throws InputError if read_parameter_file would return nothing. The error says what the
/// file has and what can be done.
ParameterFile required_parameter_file(const std::string& path, const std::string& node,
                                      std::optional<RosDistro> distro,
                                      const std::vector<std::string>& joints);

/// Reads a file into which these gains are to be written, for an arm with these joints. Its joint trajectory
/// controller follows the distribution of ROS that the gains follow. Throws InputError as
/// required_parameter_file does.
ParameterFile parameter_file_for(const Gains& gains, const std::string& path, const std::string& node,
                                 const std::vector<std::string>& joints);

/// Sets the distribution of ROS whose rules the controller follows. Throws InputError if the controller is
/// not a joint trajectory controller, or if its parameters are not those of that version of ROS.
void set_distro(ParameterFile& file, RosDistro distro);

/// Returns the files that gains are read from: `path` and, if that is a map, the file with the numbers that
/// the map binds to gains. Throws InputError if `path` cannot be read, or is a map with an error.
std::vector<std::string> files_of_gains(const std::string& path);

/// Returns true if the file is a map, or a ROS parameter file with controllers. Throws InputError if it
/// cannot be read.
bool is_parameter_file(const std::string& path);

/// Returns the same controller, with its parameters read again from `text`, the changed text of its file.
/// Throws InputError.
RosController with_text(const RosController& controller, const std::string& text, const std::string& file);

}  // namespace armtune::internal
