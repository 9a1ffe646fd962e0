#pragma once
// Solves a program of ours with Ipopt (Waechter and Biegler, Math. Prog. 106, 2006): another method and
// another implementation to compare with. Rows that bound one unknown become bounds of that unknown; all
// others stay rows. Jacobians are exact. The Hessian is ours, r's Gauss-Newton product and the rows'
// curvature, or Ipopt's limited-memory approximation.

#include <string>

#include "tuner/planning/solver/sequential_quadratic.hpp"

namespace armtune::internal {

struct IpoptOptions {
  double stationarity = 1e-6;     ///< largest entry of the Lagrangian's gradient, scaled by Ipopt
  double violation = 1e-8;        ///< largest violation of a row
  double complementarity = 1e-9;  ///< largest product of a pair: of a thousand the sum is 1e-6
  int max_iterations = 3000;
  double max_seconds = 1e6;  ///< of processor time
};

struct IpoptRun {
  PlanStatus status = PlanStatus::kStalled;
  std::string word;  ///< what Ipopt says
  int iterations = 0;
  Eigen::VectorXd z;
  Eigen::VectorXd multipliers;  ///< of the program's rows; > 0 pulls at the upper bound
};

/// Solves from z on; all rows are hard. multipliers: empty, or where to start from.
IpoptRun solve_by_ipopt(NonlinearProgram& program, const Eigen::VectorXd& z,
                        const Eigen::VectorXd& multipliers, const IpoptOptions& options);

}  // namespace armtune::internal
