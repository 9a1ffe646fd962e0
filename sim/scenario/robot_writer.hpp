#pragma once
// Generates the robot YAML for a model of an arm. This file contains the data that the model's URDF cannot
// contain, such as rotor inertia.

#include <string>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Returns the text of a robot YAML for the model. urdf: the name of the model's URDF, as urdf_text() writes
/// it. Reading both files gives the same RobotModel::chain. comment: one line for the top; may be empty. If
/// the rotor inertia of some joints is an estimate, the mark of all joints is `estimated`.
std::string robot_yaml(const RobotModel& model, const std::string& urdf, const std::string& comment = {});

/// Returns the key `limits` of a robot YAML with the model's acceleration limits, which a URDF cannot
/// contain. Empty if the model has none.
std::string acceleration_limits_yaml(const RobotModel& model);

}  // namespace armtune::internal
