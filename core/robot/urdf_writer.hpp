#pragma once
// Writes the model of an arm as the text of a URDF, with kinematics, inertia and limits but without shapes.
// Identified arms and random variants of an arm are saved in this way. Link frames are the model's body
// frames.

#include <string>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Returns the name of the URDF's last link: `tool`, followed by underscores if the name is taken in the arm.
std::string urdf_tool_link(const RobotModel& model);

/// Returns the text of the URDF. Its last link has the name that urdf_tool_link() returns, and its frame is
/// the tool frame. Its root is the base link. If the base link is tilted, the root is an additional upright
/// link below it. A chain that is read back from base link to last link is the same, except that rotor
/// inertia and friction are missing, because a URDF cannot hold them exactly.
std::string urdf_text(const RobotModel& model);

}  // namespace armtune::internal
