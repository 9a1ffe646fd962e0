#pragma once
// Reads the control rate of a ROS controller from its parameter file.

#include <optional>

#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns the `update_rate` [Hz] of the controller itself. If that is missing or 0, returns the rate of the
/// controller manager, or nothing if the file does not give that either. file: name of the file, for
/// messages. Throws InputError naming the line if the rate is not within 10 .. 10,000 Hz.
std::optional<double> controller_rate(const RosController& controller, const std::string& file);

}  // namespace armtune::internal
