#pragma once
// Writes the model of an arm as the text of a URDF, with kinematics, inertia and limits but without shapes.
// Identified arms and random variants of an arm are saved in this way. Link frames are the model's body
// frames.

#include <string>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Returns the name of the URDF's last link: `tool`, followed by underscores if the name is taken in the arm.
std::string urdf_tool_link(const RobotModel& model);

/// Returns the text of the URDF. Its last link is `urdf_tool_link`, in the tool frame. Its root is the base
/// link, or, if that is tilted, an upright link below it. If it is read back from base link to last link, it
/// gives the same chain except for rotor inertia and friction, for which a URDF has no place or no exact one.
std::string urdf_text(const RobotModel& model);

}  // namespace armtune::internal
