#pragma once
// Base parameters: the combinations of theta that an arm's motion can tell apart, and no more. Gautier,
// Numerical calculation of the base inertial parameters of robots, 1991: a column of the regressor that
// depends on those before it, at every state, regroups its parameter into theirs.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune {

struct BaseParameters {
  std::vector<int> independent;  ///< entries of theta that lead a group; their columns of Y are independent
  Eigen::MatrixXd map;  ///< rank x 13 n: theta_base = map theta, and Y theta = Y[independent] theta_base
  std::vector<std::string> names;  ///< groups: "a_link/izz + b_link/ixx - 0.612 b_link/mx ..."

  int rank() const { return static_cast<int>(independent.size()); }
};

/// Found from the regressor at random states inside the position limits; deterministic.
BaseParameters base_parameters(const RobotModel& model);

/// The regressor's rows at `states` random states (n rows each), by which the groups are found.
Eigen::MatrixXd random_regressor(const RobotModel& model, int states, unsigned seed);

}  // namespace armtune
