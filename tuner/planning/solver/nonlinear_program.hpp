#pragma once
// Declares the interface of a nonlinear program, such as a trajectory optimisation on a time grid:
//   minimise    cost^T z + |r(z)|^2 / 2
//   subject to  lower <= c(z) <= upper.
// z are the unknowns, r the residuals and c the constraint rows.

#include <vector>

#include "tuner/quadratic/quadratic_program.hpp"

namespace armtune::internal {

class NonlinearProgram {
 public:
  virtual ~NonlinearProgram() = default;

  /// Computes r(z) into `residual` and c(z) into `row`.
  virtual void evaluate(const Eigen::VectorXd& z, Eigen::VectorXd& residual, Eigen::VectorXd& row) = 0;
  /// Computes the same as evaluate(), and also writes the Jacobians of r and c into the members `residuals`
  /// and `rows`. Their sparsity patterns never change.
  virtual void linearize(const Eigen::VectorXd& z, Eigen::VectorXd& residual, Eigen::VectorXd& row) = 0;

  /// Computes the second derivatives of residual^T r(z) + y^T c(z) with respect to z, for constant residual
  /// and y, and writes them into `curvature`. The Hessian of the Lagrangian is the sum of these derivatives
  /// and of the Gauss-Newton product. The pattern of `curvature` never changes.
  virtual void curve(const Eigen::VectorXd& z, const Eigen::VectorXd& residual, const Eigen::VectorXd& y) = 0;

  int variables() const { return static_cast<int>(cost.size()); }

  Eigen::VectorXd cost;
  /// Weights above 0 that define the length of a step dz. The square of the length is the sum of metric_i *
  /// dz_i^2. With these weights, a step is about equally long on coarse and on fine grids.
  Eigen::VectorXd metric;
  /// Indices of rows whose value is positive and may at most halve or double in one step.
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
