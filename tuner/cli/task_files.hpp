#pragma once
// A first task for an arm: a folder with scenario, gains and study, to tune and to edit.

#include <memory>
#include <string>

#include "core/robot/robot_model.hpp"

namespace armtune::internal::cli {

/// Writes task.yaml, gains.yaml and study.yaml into a new folder. robot_file: where the robot is read from,
/// path or bundled name. Throws InputError if the folder holds something already, or the arm has no room for
/// a task.
void write_task_files(const std::shared_ptr<const RobotModel>& robot, const std::string& robot_file,
                      const std::string& folder);

}  // namespace armtune::internal::cli
