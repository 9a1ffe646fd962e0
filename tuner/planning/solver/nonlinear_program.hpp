#pragma once
// min  cost^T z + |r(z)|^2 / 2   s.t.  lower <= c(z) <= upper: what a trajectory becomes on a time grid.

#include <vector>

#include "tuner/planning/solver/quadratic_program.hpp"

namespace armtune::internal {

class NonlinearProgram {
 public:
  virtual ~NonlinearProgram() = default;

  /// r(z) and c(z) into `residual` and `row`.
  virtual void evaluate(const Eigen::VectorXd& z, Eigen::VectorXd& residual, Eigen::VectorXd& row) = 0;
  /// The same, and their Jacobians into `residuals` and `rows`, whose patterns never change.
  virtual void linearize(const Eigen::VectorXd& z, Eigen::VectorXd& residual, Eigen::VectorXd& row) = 0;

  /// The curvature of residual^T r(z) + y^T c(z), the weights held, into `curvature`, whose pattern never
  /// changes: what the Hessian of the Lagrangian has beside the Gauss-Newton product.
  virtual void curve(const Eigen::VectorXd& z, const Eigen::VectorXd& residual, const Eigen::VectorXd& y) = 0;

  int variables() const { return static_cast<int>(cost.size()); }

  Eigen::VectorXd cost;
  /// > 0: squared length of a step is sum metric_i dz_i^2, about the same on every grid.
  Eigen::VectorXd metric;
  /// Rows whose value is positive and may at most halve or double in one step.
  std::vector<Eigen::Index> halving_rows;
  BlockRows residuals;
  BlockRows rows;
  CurvatureBlocks curvature;
  RowBounds bounds;

 protected:
  NonlinearProgram() = default;
  NonlinearProgram(const NonlinearProgram&) = default;
  NonlinearProgram& operator=(const NonlinearProgram&) = default;
};

}  // namespace armtune::internal
