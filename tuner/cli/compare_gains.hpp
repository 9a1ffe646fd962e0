#pragma once
// `armtune compare --gains`: what differs between gain sets.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal::cli {

/// Prints the gains that differ, side by side. robot: that the sets are for; guessed: the user has not named
/// it. Throws InputError unless there are two sets or more, and each is for that robot.
void say_gains_difference(const std::vector<std::string>& sets, const RobotModel& robot, bool guessed);

}  // namespace armtune::internal::cli
