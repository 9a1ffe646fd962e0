#pragma once
// Reads the model of an arm (robot_model.hpp) from a URDF file.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_options.hpp"

namespace armtune::internal {

/// Reads an expanded URDF: a serial arm of revolute, continuous and prismatic joints, alone or as part of a
/// larger tree. Fixed links, and those after held joints, are merged into the moving link that carries them.
/// Axes are normalised. Rotor inertia is that of the transmissions (urdf_rotors.hpp), else zero. `dynamics`
/// elements give viscous and Coulomb friction. Frame 0 is the base link's frame, with gravity as it acts
/// there. Throws InputError naming the file, the link or joint, and what to do. With `missing`, it lists data
/// that are missing or wrong in `missing`, and puts placeholders for them into the model (urdf_arm.hpp).
RobotModel read_urdf(const std::string& path, const UrdfOptions& options = {},
                     MissingData* missing = nullptr);

/// Returns the data of the arm that are missing or wrong in the file and that the options do not give either.
/// Throws as read_urdf does for everything else.
MissingData missing_data(const std::string& path, const UrdfOptions& options = {});

}  // namespace armtune::internal
