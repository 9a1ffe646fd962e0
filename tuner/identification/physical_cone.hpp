#pragma once
// Minimises a quadratic function of theta, an arm's inertial and friction parameters, over all physically
// valid theta (physical_theta.hpp). It uses the alternating direction method of multipliers (Boyd et al.,
// Distributed optimization and statistical learning via ADMM, 2011). All numbers are scaled to a similar
// size: lengths by a fixed 0.2 m, masses and joint parameters by those of a prior theta.

#include <array>
#include <vector>

#include "core/robot/theta.hpp"

namespace armtune::internal {

struct PhysicalMinimum {
  ParameterVector theta;  ///< 13 n, physically valid
  bool changed = false;   ///< true if the unconstrained minimum was not valid
};

class PhysicalCone {
 public:
  /// prior (13 n): physically valid; gives the scales.
  explicit PhysicalCone(const ParameterVector& prior);

  /// Returns the matrix A^T A (13 n x 13 n) of the norm |A theta|. In this norm, every link's
  /// pseudo-inertia, with lengths in units of 0.2 m, is divided by its trace in the prior. Every joint
  /// parameter is divided by the largest of its kind in the prior, or by 1 if the prior has none above zero.
  const Eigen::MatrixXd& metric() const { return metric_; }

  struct Accuracy {
    int iterations = 20000;    ///< largest number of iterations
    double tolerance = 1e-10;  ///< relative tolerance of the primal and the dual residual
  };
  /// Minimises theta^T Q theta - 2 c^T theta. Q (13 n x 13 n): symmetric and positive definite.
  PhysicalMinimum minimum(const Eigen::MatrixXd& Q, const Eigen::VectorXd& c, const Accuracy& accuracy) const;

 private:
  Eigen::VectorXd coordinates(const Eigen::VectorXd& theta) const;
  ParameterVector theta_from(const Eigen::VectorXd& y) const;
  Eigen::VectorXd project(const Eigen::VectorXd& y, double least_eigenvalue) const;

  std::vector<double> link_unit_;
  std::array<double, kJointParameters> joint_unit_{};
  Eigen::MatrixXd map_;  ///< maps theta to coordinates: 16 for each link and 3 for each joint
  Eigen::MatrixXd metric_;
};

}  // namespace armtune::internal
