#pragma once
// Generates the text of the scenario file that the command `armtune robot --task` writes. It contains a first
// task for an arm, made from its URDF alone (default_task.hpp).

#include <string>

#include "sim/scenario/default_task.hpp"

namespace armtune::internal {

/// Returns the task as the text of a scenario file. robot: the name or path of the robot in that file. A cell
/// that was given in TaskOptions is not written, because it belongs to the robot file.
std::string default_task_yaml(const DefaultTask& task, const std::string& robot);

}  // namespace armtune::internal
