#pragma once
// A trajectory on a fine grid by way of coarse ones: where everything is far from its place the work is
// cheap, and the fine grid begins beside its solution.

#include <memory>

#include "tuner/planning/solver/sequential_quadratic.hpp"
#include "tuner/planning/transcription/trajectory_program.hpp"

namespace armtune::internal {

/// The task on a grid; grids differ in their numbers of intervals only.
using TaskOnGrid = std::function<TrajectoryTask(const TimeGrid&)>;

struct PlannedTrajectory {
  Trajectory trajectory;
  SequentialQuadraticResult result;
  std::shared_ptr<TrajectoryProgram> program;  ///< on the fine grid, unless interrupted
  double weight = 1.0;                         ///< what the program's objective is multiplied with
  int interior_iterations = 0;                 ///< on all grids
  /// Infeasible since it was given less time than it takes: then all this is the plan of the least time.
  bool too_short = false;

  double objective() const { return result.last.objective / weight; }
};

/// The grid that refining begins on.
TimeGrid coarsest(const TimeGrid& grid);

/// Solves on `grid` from the guess on. kInfeasible: on this grid not even with an objective that weighs a
/// millionth. That a coarse one has no solution says nothing.
PlannedTrajectory solve_refining(const TaskOnGrid& task, const TimeGrid& grid, const Trajectory& guess,
                                 const SequentialQuadraticOptions& options, const PlanObserver& observer);

/// Solves on `grid` alone, from a guess at its knots that keeps the limits or nearly so. The nearer a task is
/// to what is infeasible the larger grow objective and multipliers beside the price of a violation: the
/// objective is weighed by what it is at the guess.
PlannedTrajectory solve_beside(const TaskOnGrid& task, const TimeGrid& grid, const Trajectory& guess,
                               const SequentialQuadraticOptions& options, const PlanObserver& observer);

}  // namespace armtune::internal
