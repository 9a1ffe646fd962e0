#pragma once
// A first task as the text of a scenario file.

#include <string>

#include "sim/scenario/default_task.hpp"

namespace armtune::internal {

/// The task as a scenario file. robot: what the file names it by. A cell that was given is not written: it is
/// the robot file's.
std::string default_task_yaml(const DefaultTask& task, const std::string& robot);

}  // namespace armtune::internal
