#pragma once
// Generates the text of the files that `armtune identify` writes.

#include <string>
#include <vector>

#include "tuner/identification/identify.hpp"

namespace armtune::internal {

/// Returns the text of theta.yaml: every entry of theta by name. A scenario reads it by
/// `theta_start: {file: ...}`. header: comment lines at the top.
std::string theta_yaml(const RobotModel& model, const ParameterVector& theta,
                       const std::vector<std::string>& header);

/// Returns the text of base_parameters.csv: group, estimate, standard deviation, the robot file's value, the
/// value of the physically valid theta, status. Numbers read back to the same bits. For a group that the logs
/// do not excite, the standard deviation is an empty cell and the status says so.
std::string base_parameters_csv(const RobotModel& model, const Identification& found);

/// Returns the model with theta's links, rotor inertia and friction.
RobotModel with_theta(const RobotModel& model, const ParameterVector& theta);

/// Returns the text of robot.yaml, which goes beside robot.urdf. It has the tool frame, rotor inertia and
/// friction, for which a URDF has no place.
std::string robot_yaml(const RobotModel& model, const std::string& urdf);

}  // namespace armtune::internal
