#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune::internal {
namespace {

constexpr double kRoomy = 1.25;  // times the least duration: no limit is near everywhere
constexpr double kSlower = 4.0;  // a second guess, where the first leads nowhere

/// Adds up the steps of all that was tried.
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
  /// That nothing less is violated near one guess is no proof: where durations are free, before the verdict
  /// once more from a slower one, on a coarse grid first.
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
  // From the same guess as where no duration is given: the same time is found.
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
