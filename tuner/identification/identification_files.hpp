#pragma once
// What `armtune identify` leaves behind.

#include <string>
#include <vector>

#include "tuner/identification/identify.hpp"

namespace armtune::internal {

/// Text of theta.yaml: every entry of theta by name, as a scenario's `theta_start: {file: ...}` reads it.
std::string theta_yaml(const RobotModel& model, const ParameterVector& theta,
                       const std::vector<std::string>& header);

/// Text of base_parameters.csv: group, estimate, standard deviation, the robot file's value, the physically
/// valid theta's value, status. Numbers read back to the same bits; what the logs do not excite has no
/// standard deviation, an empty cell, and its status says so.
std::string base_parameters_csv(const RobotModel& model, const Identification& found);

/// The model with theta's links, rotor inertia and friction.
RobotModel with_theta(const RobotModel& model, const ParameterVector& theta);

/// Text of robot.yaml beside robot.urdf: tool frame, rotor inertia and friction, which a URDF has no place
/// for.
std::string robot_yaml(const RobotModel& model, const std::string& urdf);

}  // namespace armtune::internal
