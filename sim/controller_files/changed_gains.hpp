#pragma once
// Writing of tuned gains of a joint_trajectory_controller back into its parameter file, in which nothing but
// numbers changes.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns the text of the file with other numbers where the gains differ from its own. Reading it returns
/// these gains. Throws InputError if a gain that differs is not written in the file. Also throws if its
/// number is shared, by an alias, with another place of the file or with a gain that is to be different.
std::string with_gains(const std::string& text, const RosController& controller, const std::string& file,
                       const Gains& gains, const std::vector<std::string>& joints);

}  // namespace armtune::internal
