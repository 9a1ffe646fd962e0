#pragma once
// URDF to RobotModel.

#include <string>

#include "core/robot/robot_model.hpp"

namespace armtune {

struct UrdfOptions {
  /// Link that the tool frame is given in. Empty: `tool0` if there is one, else the last moving link.
  std::string tip_link;
  /// Tool frame in the tip link.
  Mat3 R_tip_T = Mat3::Identity();
  Vec3 p_tip_T = Vec3::Zero();
};

/// Reads an expanded URDF: a serial arm of revolute, continuous and prismatic joints; fixed links are merged
/// into the moving link that carries them; axes are normalised. Rotor inertia and friction are zero: a URDF
/// has none (its `dynamics` element is taken as viscous and Coulomb friction where present).
/// Frame 0 is the root link's frame. Throws InputError naming the file, the link or joint, and what to do.
RobotModel read_urdf(const std::string& path, const UrdfOptions& options = {});

}  // namespace armtune
