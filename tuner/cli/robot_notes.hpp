#pragma once
// Prints sentences about an arm below its tables, for `armtune robot`: position limits that are soft limits,
// acceleration limits, drives, ros2_control interfaces, and rotor inertias.

#include "core/robot/robot_model.hpp"

namespace armtune::internal::cli {

/// Prints those sentences that apply to the arm.
void show_robot_notes(const RobotModel& model);

}  // namespace armtune::internal::cli
