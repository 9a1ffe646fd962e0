#pragma once
// Solves a trajectory optimisation on coarse time grids first, and then on the fine one. Steps on a coarse
// grid are cheap while the solution is still far away. The fine grid then starts close to its solution.

#include <memory>

#include "tuner/planning/solver/sequential_quadratic.hpp"
#include "tuner/planning/transcription/trajectory_program.hpp"

namespace armtune::internal {

/// A function that returns the task on a given time grid. The grids differ only in their numbers of
/// intervals.
using TaskOnGrid = std::function<TrajectoryTask(const TimeGrid&)>;

struct PlannedTrajectory {
  Trajectory trajectory;
  SequentialQuadraticResult result;
  std::shared_ptr<TrajectoryProgram> program;  ///< on the fine grid, unless interrupted
  double weight = 1.0;                         ///< factor by which the program's objective is multiplied
  int interior_iterations = 0;                 ///< on all grids
  /// True if the plan is infeasible because the given duration is too short. All other members then describe
  /// the plan of the least time.
  bool too_short = false;

  /// Returns the task's objective, without the factor `weight`.
  double objective() const { return result.last.objective / weight; }
};

/// Returns the coarsest grid, on which solve_refining() starts.
TimeGrid coarsest(const TimeGrid& grid);

/// Solves on `grid`, starting from `guess` on coarser grids. The status kInfeasible means that no solution
/// was found on `grid` itself, not even when the objective was multiplied by 1e-6. Failure on a coarser grid
/// does not count.
PlannedTrajectory solve_refining(const TaskOnGrid& task, const TimeGrid& grid, const Trajectory& guess,
                                 const SequentialQuadraticOptions& options, const PlanObserver& observer);

/// Solves on `grid` alone. The guess has the knots (points) of this grid, and satisfies the limits, at least
/// nearly. If the problem is barely feasible, objective and multipliers can outgrow the penalty on
/// violations. The objective is therefore multiplied by a weight, which is smaller if the objective at the
/// guess is larger.
PlannedTrajectory solve_beside(const TaskOnGrid& task, const TimeGrid& grid, const Trajectory& guess,
                               const SequentialQuadraticOptions& options, const PlanObserver& observer);

}  // namespace armtune::internal
