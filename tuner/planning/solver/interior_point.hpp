#pragma once
// Primal-dual interior point method for the subproblems of a trajectory: Mehrotra's predictor and corrector
// (SIAM J. Optim. 2, 1992) on the l1-elastic program, hard equations by the proximal method of multipliers
// (Friedlander and Orban, Math. Prog. Comp. 4, 2012), so that each step condenses to one positive definite
// system K dx = r, K = H + G^T D G.

#include <functional>
#include <memory>
#include <string>

#include "tuner/planning/solver/normal_matrix.hpp"
#include "tuner/planning/solver/quadratic_program.hpp"

namespace armtune::internal {

struct InteriorPointOptions {
  int max_iterations = 80;
  double stationarity = 1e-9;     ///< sum of the entries of the Lagrangian's gradient
  double infeasibility = 1e-9;    ///< largest residual of a row
  double complementarity = 1e-7;  ///< sum of the products of the pairs
  double start_mu = 1.0;          ///< complementarity to start from; small after a warm start
  std::function<bool()> go_on;    ///< asked before each iteration; false interrupts
};

struct InteriorPointResult {
  bool solved = false;
  bool interrupted = false;
  int iterations = 0;
  double stationarity = 0.0;     ///< sum of |H x + g + G^T y|
  double infeasibility = 0.0;    ///< largest residual of a row, elastic violation allowed for
  double complementarity = 0.0;  ///< sum of the products of the pairs
};

/// Keeps pattern, analysis and memory from one program to the next of the same pattern.
class InteriorPoint {
 public:
  /// Rows must outlive it; their patterns must not change any more.
  InteriorPoint(int variables, const BlockRows& residuals, const CurvatureBlocks& curvature,
                const BlockRows& rows);

  /// Solves the program. x, y: in, where to start; out, solution and multipliers of the rows (y > 0 pulls at
  /// the upper bound).
  InteriorPointResult solve(const QuadraticProgram& program, const InteriorPointOptions& options,
                            Eigen::VectorXd& x, Eigen::VectorXd& y);

 private:
  NormalMatrix normal_;
  SparseCholesky cholesky_;
};

}  // namespace armtune::internal
