#pragma once
// A robot as a person gives it: a URDF alone, or a YAML file that names the URDF, the tool and the actuator
// data that a URDF cannot hold.

#include <memory>
#include <string>

#include "core/robot/robot_model.hpp"

namespace armtune {

/// Reads a bundled robot by name, a robot YAML or a .urdf by path. Keys of the YAML: urdf, tip_link, tool
/// {xyz, rpy}, rotor_inertia, viscous_friction, coulomb_friction (each a list in joint order, or a map by
/// joint name). The model is validated. Throws InputError.
std::shared_ptr<const RobotModel> load_robot(const std::string& name_or_path,
                                             const std::string& relative_to = {});

/// Whether a robot is given as a URDF itself (by its ending) rather than as a robot YAML or a bundled name.
bool is_urdf(const std::string& name_or_path);

}  // namespace armtune
