#pragma once
// Gains of a joint_trajectory_controller: out of its parameter file, and back into it with nothing changed
// but numbers.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Its gains for an arm with these joints, in their order; all else is as if it were not there. Throws
/// InputError "FILE:LINE: what" where a joint is missing or not the arm's, a number is not one, commands are
/// not efforts, or a parameter asks for what is not simulated: clamps that differ in both directions, limits
/// of the output, anti-windup that rests on them.
Gains joint_trajectory_gains(const RosController& controller, const std::string& file,
                             const std::vector<std::string>& joints);

/// The text of the file with other numbers where the gains differ from its own; it reads back as they are.
/// Throws InputError if a gain that differs does not stand in the file, or its number is had by an alias
/// elsewhere, or by another gain that is to be different.
std::string with_gains(const std::string& text, const RosController& controller, const std::string& file,
                       const Gains& gains, const std::vector<std::string>& joints);

}  // namespace armtune::internal
