#pragma once
// How often a ROS controller runs, out of its parameter file.

#include <optional>

#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns the controller's own `update_rate`, or that of the controller manager where it has none or 0 [Hz];
/// nothing if neither is in the file. file: its name. Throws InputError with the line for a rate that is not
/// within 10 .. 10,000 Hz.
std::optional<double> controller_rate(const RosController& controller, const std::string& file);

}  // namespace armtune::internal
