#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune::internal {
namespace {

constexpr double kRoomy = 1.25;  // times the least duration; such a motion is not near its limits everywhere
constexpr double kSlower = 4.0;  // factor on the durations of a second guess, if the first fails

/// Solves plans, and adds up the interior point steps of all attempts.
class Tries {
 public:
  Tries(const SequentialQuadraticOptions& options, const PlanObserver& observer)
      : options_(options), observer_(observer) {}

  PlannedTrajectory refining(const PlanProblem& problem, const TimeGrid& grid, const Trajectory& guess) {
    return counted(solve_refining(problem.task, grid, guess, options_, observer_));
  }
  PlannedTrajectory beside(const PlanProblem& problem, const Trajectory& guess) {
    return counted(solve_beside(problem.task, problem.grid, guess, options_, observer_));
  }
  /// Solves from the problem's guess. If this fails, the problem may still have a solution elsewhere. If a
  /// duration is free, it is therefore solved again from a slower guess, on a coarse grid first.
  PlannedTrajectory from_afar(const PlanProblem& problem) {
    PlannedTrajectory planned = refining(problem, problem.grid, problem.guess);
    TimeGrid slower = problem.grid;
    bool free = false;
    for (Phase& phase : slower.phases) {
      if (!phase.free) continue;
      phase.duration *= kSlower;
      free = true;
    }
    if (!free || planned.result.status != PlanStatus::kInfeasible) return planned;
    const PlannedTrajectory rough =
        refining(problem, coarsest(slower), in_durations_of(slower, problem.guess));
    if (rough.result.status != PlanStatus::kSolved) return planned;
    PlannedTrajectory again = refining(problem, problem.grid, rough.trajectory);
    return again.result.status == PlanStatus::kInfeasible ? planned : again;
  }

 private:
  PlannedTrajectory counted(PlannedTrajectory planned) {
    planned.interior_iterations = steps_ += planned.interior_iterations;
    return planned;
  }

  const SequentialQuadraticOptions& options_;
  const PlanObserver& observer_;
  int steps_ = 0;
};

bool ended(const PlannedTrajectory& planned) {
  return planned.result.status == PlanStatus::kSolved || planned.result.status == PlanStatus::kInterrupted;
}

}  // namespace

PlannedTrajectory solve_plan(const PlanProblem& problem, const SequentialQuadraticOptions& options,
                             const PlanObserver& observer) {
  Tries tries(options, observer);
  if (!problem.free_duration) return tries.from_afar(problem);
  const PlanProblem& free = *problem.free_duration;
  const double given = problem.grid.phases.front().duration;
  PlannedTrajectory rough = tries.refining(free, coarsest(free.grid), free.guess);
  if (rough.result.status == PlanStatus::kInterrupted) return rough;
  if (rough.result.status == PlanStatus::kSolved && given >= kRoomy * rough.trajectory.durations.front()) {
    PlannedTrajectory planned = tries.from_afar(problem);
    if (ended(planned)) return planned;
  }
  // The guess is that of a task without a duration. Thus both find the same least time.
  PlannedTrajectory least = tries.from_afar(free);
  if (least.result.status == PlanStatus::kInterrupted) return least;
  if (least.result.status != PlanStatus::kSolved) {
    PlannedTrajectory planned = tries.from_afar(problem);
    return ended(planned) || least.result.status == PlanStatus::kStalled ? planned : least;
  }
  if (given < least.trajectory.durations.front()) {
    least.result.status = PlanStatus::kInfeasible;
    least.too_short = true;
    return least;
  }
  PlannedTrajectory planned = tries.beside(problem, in_durations_of(problem.grid, least.trajectory));
  return ended(planned) ? planned : tries.from_afar(problem);
}

}  // namespace armtune::internal
