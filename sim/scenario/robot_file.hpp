#pragma once
// Reads the user's description of a robot: a URDF alone, or a YAML file that refers to a URDF. The YAML file
// selects the arm within the URDF. It also adds data that a URDF cannot contain or that this one lacks.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_options.hpp"
#include "sim/cell/cell.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

/// The contents of a robot file before its URDF is read.
struct RobotFile {
  std::string path;
  std::string urdf;  ///< path
  UrdfOptions options;
  std::optional<yaml::Node> root;  ///< content of the YAML file; empty for a URDF alone
};

/// Reads a bundled robot by name, or a robot YAML or a .urdf by path. Throws InputError.
RobotFile read_robot_file(const std::string& name_or_path, const std::string& relative_to = {});

/// Reads the whole robot and validates the model. Throws InputError. The keys of the YAML are:
///   - urdf, and those of urdf_keys.hpp;
///   - rotor_inertia, viscous_friction, coulomb_friction, link_radius [m], drive_velocity_gain and
///     drive_velocity_integral: each a list in joint order, or a map by joint name;
///   - payload: {mass, center}, a point mass in the tool frame that is part of the controller's model;
///   - drives (drive_keys.hpp);
///   - compensates_gravity (see RobotModel);
///   - cell (see cell_of).
/// `rotor_inertia: estimated` makes armtune estimate the rotor inertia of every joint that has none in the
/// URDF (rotor_estimate.hpp). `{MARK: NUMBERS}` as the value of rotor_inertia, viscous_friction or
/// coulomb_friction says where the numbers come from. The marks are those of value_source.hpp.
/// Without link_radius, a link's radius is that of its shapes (link_radius.hpp).
std::shared_ptr<const RobotModel> load_robot(const std::string& name_or_path,
                                             const std::string& relative_to = {});

/// Reads the rest of a robot file. With `missing`, it does not throw for data that are missing or wrong in
/// the URDF. Instead it lists them in `missing`, and puts placeholders into the model, which must then not be
/// simulated.
std::shared_ptr<const RobotModel> load_robot(const RobotFile& file, MissingData* missing = nullptr);

/// Returns the cell around the arm, which the key `cell` of a robot file describes (cell_file.hpp). Returns
/// nothing if the file does not have this key. The names of waypoint files that this reads are added to
/// `inputs`. Throws InputError.
std::optional<Cell> cell_of(const RobotFile& file, std::vector<std::string>& inputs);

/// Returns true if the name has the ending of an XML file, and so is neither a robot YAML nor a bundled name.
/// SDF and MJCF count too, so that the URDF reader can name them in its error message.
bool is_urdf(const std::string& name_or_path);

}  // namespace armtune::internal
