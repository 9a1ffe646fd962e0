#pragma once
// What `armtune identify` prints: base parameters, what is left unexplained joint by joint, and what to look
// at.

#include "core/robot/robot_model.hpp"
#include "tuner/identification/identify.hpp"

namespace armtune::cli {

void print_identification(const RobotModel& model, const Identification& found);

}  // namespace armtune::cli
