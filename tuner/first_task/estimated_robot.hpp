#pragma once
// Makes a robot file with estimated rotor inertia for an arm whose files do not give it.

#include <string>

#include "core/robot/robot_model.hpp"
#include "sim/scenario/robot_file.hpp"

namespace armtune::internal {

/// True if some joint has no rotor inertia and the robot file does not set `rotor_inertia` itself.
bool lacks_rotors(const RobotFile& file, const RobotModel& robot);

/// Returns the text of a robot YAML file with the contents of `file` and `rotor_inertia: estimated`.
/// estimated: the arm with the estimate, whose values a comment in the text shows. Throws InputError if the
/// file is written in a way that cannot be extended.
std::string estimated_robot_yaml(const RobotFile& file, const RobotModel& estimated);

}  // namespace armtune::internal
