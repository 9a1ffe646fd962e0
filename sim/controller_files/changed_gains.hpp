#pragma once
// Gains of a joint_trajectory_controller back into its parameter file, with nothing changed but numbers.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// The text of the file with other numbers where the gains differ from its own; it reads back as they are.
/// Throws InputError if a gain that differs does not stand in the file, or its number is had by an alias
/// elsewhere, or by another gain that is to be different.
std::string with_gains(const std::string& text, const RosController& controller, const std::string& file,
                       const Gains& gains, const std::vector<std::string>& joints);

}  // namespace armtune::internal
