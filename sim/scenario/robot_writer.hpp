#pragma once
// A RobotModel as files: a URDF, and the robot YAML that says what a URDF cannot hold.

#include <string>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Returns the text of a robot YAML for the model whose URDF, as urdf_text() writes it, is called `urdf`.
/// Reading it gives the same chain. comment: one line, for its top; may be empty.
std::string robot_yaml(const RobotModel& model, const std::string& urdf, const std::string& comment = {});

}  // namespace armtune::internal
