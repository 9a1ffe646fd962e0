#pragma once
// The command `armtune compare --gains`, which shows the differences between gain sets.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal::cli {

/// Prints the gains that differ, side by side. robot: the arm that the sets are for; guessed: true if the
/// user did not name this arm. Throws InputError if there are fewer than two sets, or if a set is not for
/// this arm.
void say_gains_difference(const std::vector<std::string>& sets, const RobotModel& robot, bool guessed);

}  // namespace armtune::internal::cli
