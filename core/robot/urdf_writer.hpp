#pragma once
// A RobotModel as a URDF: kinematics, inertia and limits, without shapes. Link frames are the model's body
// frames.

#include <string>

#include "core/robot/robot_model.hpp"

namespace armtune {

/// Text of the URDF. Its last link is `tool`, in the tool frame. Reading it back gives the same chain but for
/// rotor inertia and friction, which a URDF has no or no exact place for.
std::string urdf_text(const RobotModel& model);

}  // namespace armtune
