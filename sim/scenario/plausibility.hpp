#pragma once
// Figures of a robot file that are valid and still can hardly be those of an arm: placeholders, other units,
// a gripper taken for a joint. They make a simulation quietly wrong.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Returns one sentence for each doubt, with names, values and what to do; empty if there is none. It doubts
/// links too light for their joint's effort, inertia that no body of the mass can have, position limits and
/// velocities that look like degrees, efforts that cannot hold the arm, and a last joint that moves like a
/// gripper's finger.
std::vector<std::string> doubts(const RobotModel& robot);

}  // namespace armtune::internal
