#pragma once
// The linear system of an interior point step, all pairs eliminated:
//
//   [H + delta I   G^T  ] [x]   [rd]      H = R^T R + C + diag(damping),
//   [G            -yield] [y] = [e ],     yield >= 0: how far a row gives way to its multiplier.
//
// Rows that do not give way at all get a dual proximal part, 1/D = yield + a little, and the system condenses
// to the positive definite K = H + delta I + G^T D G (Friedlander and Orban, Math. Prog. Comp. 4, 2012).
// Conjugate gradients then take that part out of the rows again.

#include "tuner/planning/solver/normal_matrix.hpp"
#include "tuner/planning/solver/quadratic_program.hpp"

namespace armtune::internal {

struct LinearUnknowns {
  Eigen::VectorXd x;  ///< (variables)
  Eigen::VectorXd y;  ///< (rows)
};

/// What a solution may leave of the right-hand sides.
struct LinearAccuracy {
  double sum = 0.0;   ///< of the first rows: sum of |entries|
  double rows = 0.0;  ///< of the second rows: largest |entry|
};

/// Factorised once a step, then solved for as many right-hand sides as wanted.
class CondensedSystem {
 public:
  /// All three must outlive it. normal: laid out for the program's R and G, in this order; cholesky: analysed
  /// for it.
  CondensedSystem(const QuadraticProgram& program, NormalMatrix& normal, SparseCholesky& cholesky);

  /// yield (rows, >= 0) is read again by every solve until the next call. False if K is not positive definite
  /// with the largest delta either.
  bool factorize(const Eigen::VectorXd& yield);
  /// Primal proximal part of the last factorisation.
  double delta() const { return delta_; }

  /// Solves for (rd, e). Stops short of the accuracy where the conjugate gradients no longer help.
  void solve(const Eigen::VectorXd& rd, const Eigen::VectorXd& e, const LinearAccuracy& accuracy,
             LinearUnknowns& found);
  /// The same with 1/D in place of yield, by one solve with K. found.x: in, rd; out, x.
  void solve_proximal(const Eigen::VectorXd& e, LinearUnknowns& found);

  /// result = H v.
  void hessian_times(const Eigen::VectorXd& v, Eigen::VectorXd& result);

 private:
  /// What d leaves of the second rows.
  void rows_left(const Eigen::VectorXd& e, const LinearUnknowns& d, Eigen::VectorXd& left);
  /// Takes what is left of the rows (in r2_) out of d until it is `within`. Solving again for what is left
  /// brings y nearer by (S + 1/D - yield)^-1 S, S = yield + G (H + delta)^-1 G^T: 1 but in the few directions
  /// where active limits pin all motion. So conjugate gradients on that matrix need few steps where repeating
  /// alone may need hundreds.
  void make_rows_exact(double within, LinearUnknowns& d);

  const QuadraticProgram& program_;
  const BlockRows& R_;
  const BlockRows& G_;
  NormalMatrix& normal_;
  SparseCholesky& cholesky_;
  double delta_ = 0.0;
  const Eigen::VectorXd* yield_ = nullptr;
  Eigen::VectorXd D_;
  Eigen::VectorXd ones_;  ///< empty: stands for ones
  LinearUnknowns step_, gap_, image_;
  Eigen::VectorXd r1_, r2_, De_, Gx_, Rx_, Hx_, minus_y_, moved_;
};

}  // namespace armtune::internal
