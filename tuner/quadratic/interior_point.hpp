#pragma once
// Solves quadratic programs, such as the subproblems of a trajectory optimisation, by a primal-dual
// interior point method. The method uses Mehrotra's predictor and corrector (SIAM J. Optim. 2, 1992). Some
// constraint rows are elastic: they may be violated at an l1 penalty. Hard equations are treated by the
// proximal method of multipliers (Friedlander and Orban, Math. Prog. Comp. 4, 2012). Each step thereby
// reduces to one linear system with the positive definite matrix K = H + delta I + G^T D G. H is the Hessian,
// delta a small constant, G has the constraint rows, and D is a diagonal matrix (condensed_system.hpp).

#include <functional>
#include <memory>
#include <string>

#include "tuner/quadratic/normal_matrix.hpp"
#include "tuner/quadratic/quadratic_program.hpp"

namespace armtune::internal {

struct InteriorPointOptions {
  int max_iterations = 80;
  double stationarity = 1e-9;     ///< tolerance of the sum of |entries| of the Lagrangian's gradient
  double infeasibility = 1e-9;    ///< tolerance of the largest residual of a row
  double complementarity = 1e-7;  ///< tolerance of the sum of slack x multiplier over all bounds
  double start_mu = 1.0;          ///< initial slack x multiplier of every bound; small for a warm start
  std::function<bool()> go_on;    ///< called before each iteration; returns false to interrupt
};

struct InteriorPointResult {
  bool solved = false;
  bool interrupted = false;
  int iterations = 0;
  double stationarity = 0.0;     ///< sum of |H x + g + G^T y|
  double infeasibility = 0.0;    ///< largest residual of a row after its elastic violation is subtracted
  double complementarity = 0.0;  ///< sum of slack x multiplier over all bounds
};

/// A solver for quadratic programs with the same sparsity pattern. It reuses the analysis of the pattern and
/// the memory from one program to the next.
class InteriorPoint {
 public:
  /// Residuals, curvature and rows must outlive the solver. Their sparsity patterns must not change
  /// afterwards. make_cholesky: make_dense_cholesky, or make_sparse_cholesky for programs with thousands of
  /// variables and few of them in each row.
  InteriorPoint(int variables, const BlockRows& residuals, const CurvatureBlocks& curvature,
                const BlockRows& rows, MakeCholesky make_cholesky);

  /// Solves the program. x, y: the starting point on entry; on return the solution and the multipliers of the
  /// rows, positive if the upper bound is active.
  InteriorPointResult solve(const QuadraticProgram& program, const InteriorPointOptions& options,
                            Eigen::VectorXd& x, Eigen::VectorXd& y);

 private:
  NormalMatrix normal_;
  std::unique_ptr<Cholesky> cholesky_;
};

}  // namespace armtune::internal
