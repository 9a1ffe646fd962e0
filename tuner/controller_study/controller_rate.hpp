#pragma once
// Reads the control rate of a ROS controller from its parameter file.

#include <optional>
#include <string>

#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

struct ControllerRate {
  double hertz = 0.0;
  std::string key;  ///< of the file, such as "controller_manager/update_rate"
};

/// Returns the `update_rate` of the controller itself. If that is missing or 0, returns the `update_rate` of
/// the controller manager (ROS 2). If the file has no `update_rate`, returns the `loop_hz` of the control
/// loop (ROS 1): of a node called `hardware_interface`, or whose name ends with `control_loop`. Returns
/// nothing if the file does not give that either. file: name of the file, for messages. Throws InputError
/// naming the line if the rate is not within 10 .. 10,000 Hz.
std::optional<ControllerRate> controller_rate(const RosController& controller, const std::string& file);

}  // namespace armtune::internal
