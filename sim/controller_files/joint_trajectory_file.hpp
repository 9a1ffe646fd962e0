#pragma once
// Gains of a joint_trajectory_controller out of its parameter file.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Its gains for an arm with these joints, in their order; all else is as if it were not there. Throws
/// InputError "FILE:LINE: what" where a joint is missing or not the arm's, a number is not one, commands are
/// neither efforts nor velocities alone, or a parameter asks for what is not simulated: clamps that differ in
/// both directions, limits of the output, anti-windup that rests on them.
Gains joint_trajectory_gains(const RosController& controller, const std::string& file,
                             const std::vector<std::string>& joints);

}  // namespace armtune::internal
