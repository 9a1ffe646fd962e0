#pragma once
// Generates the text of the files that `armtune identify` writes.

#include <string>
#include <vector>

#include "tuner/identification/identify.hpp"

namespace armtune::internal {

/// Returns the text of theta.yaml. It has every entry of theta, the arm's inertial and friction parameters,
/// by name. A scenario reads it by `theta_start: {file: ...}`. header: comment lines at the top.
std::string theta_yaml(const RobotModel& model, const ParameterVector& theta,
                       const std::vector<std::string>& header);

/// Returns the text of base_parameters.csv, with one row per base parameter (group of entries of theta). Its
/// columns are group, estimate, standard deviation, the robot file's value, the value of the physically valid
/// theta, and status. Numbers have all digits that are needed to read back the same value. For a group that
/// the logs do not excite, the standard deviation is an empty cell and the status says so.
std::string base_parameters_csv(const RobotModel& model, const Identification& found);

/// Returns a copy of the model that has the links, rotor inertia and friction of theta.
RobotModel with_theta(const RobotModel& model, const ParameterVector& theta);

/// Returns the text of robot.yaml, which belongs to the file robot.urdf in the same folder. It names the
/// base and tool frames, and gives what robot.urdf does not contain: rotor inertia, friction and
/// acceleration limits.
std::string identified_robot_yaml(const RobotModel& model, const std::string& urdf);

}  // namespace armtune::internal
