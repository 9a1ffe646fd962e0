#pragma once
// Base parameters: the combinations of theta that an arm's motion can tell apart, and no more. Gautier,
// Numerical calculation of the base inertial parameters of robots, 1991: a column of the regressor that
// depends on those before it, at every state, regroups its parameter into theirs.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

struct BaseParameters {
  std::vector<int> independent;  ///< entries of theta that lead a group; their columns of Y are independent
  Eigen::MatrixXd map;  ///< rank x 13 n: theta_base = map theta, and Y theta = Y[independent] theta_base
  std::vector<std::string> names;  ///< groups: "a_link/izz + b_link/ixx - 0.612 b_link/mx ..."

  int rank() const { return static_cast<int>(independent.size()); }
};

/// How large the parameters of such an arm are (13 n), above zero, whatever the robot file leaves at zero:
/// first moments and inertias by the links' masses and widths; rotor inertia and friction as in the file, and
/// at least what a hundredth or two of the effort limit is at 1 rad/s^2, the velocity limit, and at rest.
Eigen::VectorXd parameter_sizes(const RobotModel& model);

/// Size of every group (rank), above zero: what the sizes of its members in theta (13 n) add up to.
Eigen::VectorXd group_sizes(const BaseParameters& base, const Eigen::VectorXd& theta);

/// Found from the regressor at random states inside the position limits; deterministic.
BaseParameters base_parameters(const RobotModel& model);

/// The regressor's rows at `states` random states (n rows each), by which the groups are found.
Eigen::MatrixXd random_regressor(const RobotModel& model, int states, unsigned seed);

}  // namespace armtune::internal
