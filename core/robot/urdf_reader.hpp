#pragma once
// URDF to RobotModel.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_options.hpp"

namespace armtune::internal {

/// Reads an expanded URDF: a serial arm of revolute, continuous and prismatic joints, alone or out of a
/// larger tree; fixed links, and those behind held joints, are merged into the moving link that carries them;
/// axes are normalised. Rotor inertia is that of its transmissions (urdf_rotors.hpp), else zero; its
/// `dynamics` elements are taken as viscous and Coulomb friction. Frame 0 is the base link's frame, gravity
/// as it is felt there. Throws InputError naming the file, the link or joint, and what to do.
RobotModel read_urdf(const std::string& path, const UrdfOptions& options = {});

/// All that a file leaves open of the arm that the options take out of it. Throws as read_urdf does for
/// everything else.
MissingData missing_data(const std::string& path, const UrdfOptions& options = {});

}  // namespace armtune::internal
