#pragma once
// Prints what `armtune robot` knows of an arm: joints, limits, masses, rotors, interfaces, and which links
// are checked for self-collision.

#include "core/robot/robot_model.hpp"

namespace armtune::internal::cli {

/// Prints the arm, and warnings of its doubtful values.
void show_robot(const RobotModel& model);

/// Prints a table of the bundled arms.
void list_bundled_robots();

}  // namespace armtune::internal::cli
