#pragma once
// Reads the control rate of a ROS controller from its parameter file.

#include <optional>

#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns the controller's own `update_rate` [Hz], or that of the controller manager if the controller has
/// none or 0. Returns nothing if neither is in the file. file: its name. Throws InputError with the line if
/// the rate is not within 10 .. 10,000 Hz.
std::optional<double> controller_rate(const RosController& controller, const std::string& file);

}  // namespace armtune::internal
