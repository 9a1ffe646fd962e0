#pragma once
// A robot file for an arm whose rotor inertia nobody gives.

#include <string>

#include "core/robot/robot_model.hpp"
#include "sim/scenario/robot_file.hpp"

namespace armtune::internal {

/// Returns true if some joint has no rotor inertia and the robot file does not say so itself.
bool lacks_rotors(const RobotFile& file, const RobotModel& robot);

/// Returns the text of a robot YAML that says what `file` says, and `rotor_inertia: estimated`. `estimated`:
/// the arm with it, whose figures the comment shows. Throws InputError if the file is written in a way that
/// cannot be added to.
std::string estimated_robot_yaml(const RobotFile& file, const RobotModel& estimated);

}  // namespace armtune::internal
