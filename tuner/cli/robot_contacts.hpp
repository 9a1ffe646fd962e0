#pragma once
// Prints which links of an arm are checked for self-collision, for `armtune robot`.

#include "core/robot/robot_model.hpp"

namespace armtune::internal::cli {

/// Prints between which links self-collision is checked, and warns of shapes that are far too large.
void show_contacts(const RobotModel& model);

}  // namespace armtune::internal::cli
