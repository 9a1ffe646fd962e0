#pragma once
// A robot as a person gives it: a URDF alone, or a YAML file beside it that says which part of the URDF is
// the arm and what a URDF cannot hold or this one does not.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_options.hpp"
#include "sim/cell/cell.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

/// What is read of it before the URDF is.
struct RobotFile {
  std::string path;
  std::string urdf;  ///< path
  UrdfOptions options;
  std::optional<yaml::Node> root;  ///< of a YAML file
};

/// A bundled robot by name, a robot YAML or a .urdf by path. Throws InputError.
RobotFile read_robot_file(const std::string& name_or_path, const std::string& relative_to = {});

/// Reads it whole. Keys of the YAML: urdf, those of urdf_keys.hpp, and rotor_inertia, viscous_friction,
/// coulomb_friction, link_radius [m], drive_velocity_gain and drive_velocity_integral (each a list in joint
/// order, or a map by joint name), and payload:
/// {mass, center}, a point mass in the tool frame that the controller knows of, and compensates_gravity
/// (RobotModel). `rotor_inertia: estimated`
/// estimates it for every joint that has none in the URDF (rotor_estimate.hpp); `{estimated: ...}` marks
/// numbers as the file's own estimate. A link's radius is otherwise
/// that of its shapes (link_radius.hpp). The model is validated. Throws InputError.
std::shared_ptr<const RobotModel> load_robot(const std::string& name_or_path,
                                             const std::string& relative_to = {});

/// Returns the cell that a robot file says the arm stands in (cell_file.hpp); nothing if it says none. Files
/// that it names are added to `inputs`. Throws InputError.
std::optional<Cell> cell_of(const RobotFile& file, std::vector<std::string>& inputs);

/// Returns true if a robot is given by the ending of an XML file, rather than as a robot YAML or a bundled
/// name. SDF and MJCF are among them, for the URDF's reader to name.
bool is_urdf(const std::string& name_or_path);

}  // namespace armtune::internal
