#pragma once
// A RobotModel as a URDF: kinematics, inertia and limits, without shapes. Link frames are the model's body
// frames.

#include <string>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Name of the URDF's last link: `tool`, with underscores after it where the arm has a link of that name.
std::string urdf_tool_link(const RobotModel& model);

/// Text of the URDF. Its last link is `urdf_tool_link`, in the tool frame; its root the base link, or an
/// upright one below it where that is tilted. Reading it back, between the two, gives the same chain but for
/// rotor inertia and friction, which a URDF has no or no exact place for.
std::string urdf_text(const RobotModel& model);

}  // namespace armtune::internal
