#pragma once
// Approximates the Hessian of a Lagrangian by Powell's damped BFGS update (Nocedal and Wright, Numerical
// Optimization, 2nd ed., procedure 18.2). The Hessian of a Lagrangian can have negative curvature. The
// damping keeps the approximation positive definite all the same.

#include <Eigen/Core>

namespace armtune::internal {

/// Updates B (n x n, symmetric positive definite) from a step s (n) and the change y (n) of the Lagrangian's
/// gradient along it. B stays positive definite. A step of length zero, or a y that is not finite, changes
/// nothing.
void update_damped_bfgs(Eigen::MatrixXd& B, const Eigen::VectorXd& s, const Eigen::VectorXd& y);

}  // namespace armtune::internal
