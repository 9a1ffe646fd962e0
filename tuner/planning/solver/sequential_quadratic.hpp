#pragma once
// Solves the nonlinear program of a trajectory by sequential quadratic programming. The Hessian is the sum of
// the Gauss-Newton product and the second derivatives of residuals and constraint rows. Levenberg-Marquardt
// damping takes the place of a trust region. A filter accepts or rejects steps (Fletcher and Leyffer, Math.
// Prog. 91, 2002). If even the solution of the subproblem violates constraints, the l1 merit function decides
// instead (Nocedal and Wright, Numerical Optimization, 18.5).

#include <functional>

#include "tuner/planning/solver/nonlinear_program.hpp"
#include "tuner/quadratic/interior_point.hpp"

namespace armtune::internal {

struct SequentialQuadraticOptions {
  int max_iterations = 200;
  double stationarity = 1e-6;     ///< tolerance of the sum of |entries| of the Lagrangian's gradient (scaled)
  double violation = 1e-8;        ///< tolerance of the largest violation of a row
  double complementarity = 1e-6;  ///< tolerance of sum of |multiplier| x row's distance from its bound
  double damping = 1e-3;          ///< initial damping
};

/// The way in which the solver ended. kStalled: it made no more progress or reached max_iterations, and the
/// problem is neither solved nor found infeasible.
enum class PlanStatus { kSolved, kInfeasible, kStalled, kInterrupted };

struct SequentialQuadraticProgress {
  int iteration = 0;
  int knots = 0;                ///< number of knots (points) of the present time grid
  int interior_iterations = 0;  ///< iterations of all subproblems so far
  double objective = 0.0;
  double violation = 0.0;
  double stationarity = 0.0;
  double complementarity = 0.0;
  double damping = 0.0;
  double step = 0.0;  ///< largest entry of the last step
};

struct SequentialQuadraticResult {
  PlanStatus status = PlanStatus::kStalled;
  SequentialQuadraticProgress last;
  Eigen::VectorXd z;
  Eigen::VectorXd multipliers;  ///< one per row; positive if its upper bound is active
};

/// A function that is called before every iteration of the subproblems. It returns false to interrupt the
/// solver.
using PlanObserver = std::function<bool(const SequentialQuadraticProgress&)>;

/// Solves the program, starting from z. multipliers: initial multipliers of the rows, or empty.
SequentialQuadraticResult solve(NonlinearProgram& program, Eigen::VectorXd z, Eigen::VectorXd multipliers,
                                const SequentialQuadraticOptions& options, const PlanObserver& observer);

}  // namespace armtune::internal
