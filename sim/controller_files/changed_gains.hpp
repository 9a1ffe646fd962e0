#pragma once
// Writes tuned gains back into the ROS parameter file of their controller. Only the numbers of the gains
// change in the file. Comments, layout and all other parameters stay.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns the file's text with new numbers for all gains whose value in the file differs from `gains`.
/// Reading the returned text gives exactly `gains`. Throws InputError if:
///   - `gains` are for another kind of controller than the file,
///   - a gain that must change has no number in the file,
///   - the number of such a gain is shared, through a YAML alias, with another place of the file or with a
///     gain that needs another value.
std::string with_gains(const std::string& text, const RosController& controller, const std::string& file,
                       const Gains& gains, const std::vector<std::string>& joints);

}  // namespace armtune::internal
