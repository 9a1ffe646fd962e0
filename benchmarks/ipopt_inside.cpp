// Replaces the planner's own solver by Ipopt: the linker takes this definition of `solve` in place of the
// library's.

#include <algorithm>

#include "ipopt_solver.hpp"
#include "tuner/planning/solver/violation_price.hpp"

namespace armtune::internal {

SequentialQuadraticResult solve(NonlinearProgram& program, Eigen::VectorXd z, Eigen::VectorXd multipliers,
                                const SequentialQuadraticOptions& options, const PlanObserver& observer) {
  SequentialQuadraticResult result;
  if (observer && !observer(result.last)) {
    result.status = PlanStatus::kInterrupted;
    result.z = std::move(z);
    result.multipliers = Eigen::VectorXd::Zero(program.rows.rows());
    return result;
  }
  IpoptOptions asked;
  asked.max_seconds = 60.0;
  asked.stationarity = options.stationarity;
  asked.violation = options.violation;
  asked.complementarity = 1e-3 * options.complementarity;  // Ipopt's is of one pair, the planner's of the sum
  IpoptRun run = solve_by_ipopt(program, z, multipliers, asked);
  result.status = run.status;
  result.z = std::move(run.z);
  result.multipliers = std::move(run.multipliers);
  result.last.iteration = result.last.interior_iterations = run.iterations;
  result.last.damping = options.damping;
  Eigen::VectorXd residual, row;
  program.linearize(result.z, residual, row);
  result.last.objective = program.cost.dot(result.z) + 0.5 * residual.squaredNorm();
  for (Eigen::Index i = 0; i < row.size(); ++i)
    result.last.violation = std::max(result.last.violation, violation(program.bounds, i, row[i]));
  return result;
}

}  // namespace armtune::internal
