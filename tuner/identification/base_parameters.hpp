#pragma once
// Computes base parameters: the smallest set of linear combinations of theta, an arm's inertial and friction
// parameters, that determines its dynamics. Only these combinations can be identified from logs. If a column
// of the regressor is, in every state, a linear combination of columns before it, its parameter is not a
// base parameter of its own. Instead it is added to the base parameters of those columns, multiplied by the
// factors of that combination. A base parameter with everything that is added to it is called a group.
// Gautier, Numerical calculation of the base inertial parameters of robots, 1991.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

struct BaseParameters {
  std::vector<int> independent;  ///< entries of theta that lead a group; their columns of Y are independent
  Eigen::MatrixXd map;  ///< rank x 13 n: theta_base = map * theta; Y * theta = Y[independent] * theta_base
  std::vector<std::string> names;  ///< groups: "a_link/izz + b_link/ixx - 0.612 b_link/mx ..."

  int rank() const { return static_cast<int>(independent.size()); }
};

/// Returns the typical size of every entry of theta for the arm (13 n), above zero even where the robot file
/// has zero. First moments and inertias follow from the links' masses and widths. Rotor inertia and friction
/// are those of the file, but at least so large that they need this share of the effort limit: rotor inertia
/// 1 % at 1 rad/s^2, viscous friction 2 % at the velocity limit, Coulomb friction 2 %.
Eigen::VectorXd parameter_sizes(const RobotModel& model);

/// Returns the size of every group (rank), above zero: the sum of its members' sizes in theta (13 n).
Eigen::VectorXd group_sizes(const BaseParameters& base, const Eigen::VectorXd& theta);

/// Computes the base parameters from the regressor at random states inside the position limits. The states
/// have a fixed seed, so the result is deterministic.
BaseParameters base_parameters(const RobotModel& model);

/// Returns the regressor's rows at `states` random states, n rows for each. base_parameters finds the groups
/// from such rows.
Eigen::MatrixXd random_regressor(const RobotModel& model, int states, unsigned seed);

}  // namespace armtune::internal
