#pragma once
// Prints the output of `armtune robot`: an arm's joints, limits, masses, rotor inertia and ros2_control
// interfaces, and which links are checked for self-collision.

#include "core/robot/robot_model.hpp"

namespace armtune::internal::cli {

/// Prints the arm, and warnings about doubtful values.
void show_robot(const RobotModel& model);

/// Prints a table of the bundled arms.
void list_bundled_robots();

}  // namespace armtune::internal::cli
