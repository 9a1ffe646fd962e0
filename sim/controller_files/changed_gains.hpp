#pragma once
// Writes tuned gains back into the parameter file of a ROS joint_trajectory_controller. Only the numbers of
// the gains change in the file; comments, layout and all other parameters stay.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns the text of the file with new numbers for the gains that differ from its own. Reading this text
/// returns exactly `gains`. Throws InputError if `gains` are for another kind of controller, or if a gain
/// that differs has no number in the file. Also throws if a YAML alias shares that number with another place
/// of the file, or with a gain that needs another value.
std::string with_gains(const std::string& text, const RosController& controller, const std::string& file,
                       const Gains& gains, const std::vector<std::string>& joints);

}  // namespace armtune::internal
