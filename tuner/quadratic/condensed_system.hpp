#pragma once
// Solves the linear system of an interior point step (interior_point.hpp), after the complementarity
// conditions have been eliminated:
//
//   [H + delta I   G^T  ] [x]   [rd]
//   [G            -yield] [y] = [e ]
//
//   x, y: the changes of the variables and of the multipliers of the rows
//   H = R^T R + C + diag(damping): the Hessian of the step, where R^T R is its Gauss-Newton part and C its
//       curvature (normal_matrix.hpp)
//   G: the Jacobian of the rows
//   yield >= 0 (one per row): the compliance of a row, that is, how far G x deviates from e per unit of y
//   delta: a small constant, the primal proximal part
//   rd, e: the residuals of the step
//
// Rows with yield 0 cannot be eliminated. Therefore a second small constant, the dual proximal part, is added
// to yield: 1/D = yield + constant. The system then reduces to one with the positive definite matrix
// K = H + delta I + G^T D G (Friedlander and Orban, Math. Prog. Comp. 4, 2012). Conjugate gradients
// afterwards remove the error that the second constant causes.

#include "tuner/quadratic/normal_matrix.hpp"
#include "tuner/quadratic/quadratic_program.hpp"

namespace armtune::internal {

struct LinearUnknowns {
  Eigen::VectorXd x;  ///< (variables)
  Eigen::VectorXd y;  ///< (rows)
};

/// The largest residuals that are allowed in a solution.
struct LinearAccuracy {
  double sum = 0.0;   ///< sum of |entries| in the first block row
  double rows = 0.0;  ///< largest |entry| in the second block row
};

/// A system that is factorised once per step, then solved for any number of right-hand sides.
class CondensedSystem {
 public:
  /// All three arguments must outlive the system. normal: was made for the program's R and G, in this order;
  /// cholesky: was made for the pattern of `normal`.
  CondensedSystem(const QuadraticProgram& program, NormalMatrix& normal, Cholesky& cholesky);

  /// Factorises the system. Returns false if K is not positive definite even with the largest delta. yield
  /// (rows, >= 0): must live until the next call, since every solve reads it again.
  bool factorize(const Eigen::VectorXd& yield);
  /// Returns the primal proximal part of the last factorisation.
  double delta() const { return delta_; }

  /// Solves the system for the right-hand sides (rd, e). The accuracy may be missed, because the number of
  /// conjugate gradient steps is limited.
  void solve(const Eigen::VectorXd& rd, const Eigen::VectorXd& e, const LinearAccuracy& accuracy,
             LinearUnknowns& found);
  /// Solves the system with 1/D in place of yield, by one solve with K. found.x: rd on entry, x on return.
  void solve_proximal(const Eigen::VectorXd& e, LinearUnknowns& found);

  /// Computes result = H v.
  void hessian_times(const Eigen::VectorXd& v, Eigen::VectorXd& result);

 private:
  /// Computes the residual of d in the second block row.
  void rows_left(const Eigen::VectorXd& e, const LinearUnknowns& d, Eigen::VectorXd& left);
  /// Corrects d until the residual of the second block row (in r2_) is at most `within`. One more proximal
  /// solve for this residual removes the part (S + 1/D - yield)^-1 S of the error of y, where
  /// S = yield + G (H + delta I)^-1 G^T. This matrix is close to the identity except in the few directions in
  /// which active limits prevent all motion. Conjugate gradients on it therefore need few steps. Repeated
  /// solves alone may need hundreds.
  void make_rows_exact(double within, LinearUnknowns& d);

  const QuadraticProgram& program_;
  const BlockRows& R_;
  const BlockRows& G_;
  NormalMatrix& normal_;
  Cholesky& cholesky_;
  double delta_ = 0.0;
  const Eigen::VectorXd* yield_ = nullptr;
  Eigen::VectorXd D_;
  Eigen::VectorXd ones_;  ///< empty vector, which NormalMatrix::assemble() takes for ones
  LinearUnknowns step_, gap_, image_;
  Eigen::VectorXd r1_, r2_, De_, Gx_, Rx_, Hx_, minus_y_, moved_;
};

}  // namespace armtune::internal
