#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune {
namespace {

constexpr double kRoomy = 1.25;  // times the least duration: no limit is near everywhere

/// The same way in the grid's durations, with its own velocity at the start.
Trajectory stretched(Trajectory motion, const TimeGrid& grid) {
  const double last = motion.durations.back();
  motion.durations.clear();
  motion.time = {grid.start};
  double start = grid.start;
  for (const Phase& phase : grid.phases) {
    motion.durations.push_back(phase.duration);
    for (int i = 1; i <= phase.intervals; ++i)
      motion.time.push_back(start + phase.duration * i / phase.intervals);
    start += phase.duration;
  }
  motion.velocity.rightCols<1>() *= last / motion.durations.back();
  return motion;
}

}  // namespace

PlannedTrajectory solve_plan(const PlanProblem& problem, const SequentialQuadraticOptions& options,
                             const PlanObserver& observer) {
  if (!problem.free_duration)
    return solve_refining(problem.task, problem.grid, problem.guess, options, observer);
  const PlanProblem& free = *problem.free_duration;
  const double given = problem.grid.phases.front().duration;
  int steps = 0;
  const auto counted = [&steps](PlannedTrajectory planned) {
    planned.interior_iterations = steps += planned.interior_iterations;
    return planned;
  };
  const auto ended = [](const PlannedTrajectory& planned) {
    return planned.result.status == PlanStatus::kSolved || planned.result.status == PlanStatus::kInterrupted;
  };
  const auto from_afar = [&] {
    return counted(solve_refining(problem.task, problem.grid, problem.guess, options, observer));
  };
  PlannedTrajectory rough =
      counted(solve_refining(free.task, coarsest(free.grid), free.guess, options, observer));
  if (rough.result.status == PlanStatus::kInterrupted) return rough;
  if (rough.result.status == PlanStatus::kSolved && given >= kRoomy * rough.trajectory.durations.front()) {
    PlannedTrajectory planned = from_afar();
    if (ended(planned)) return planned;
  }
  // From the same guess as where no duration is given: the same time is found.
  PlannedTrajectory least = counted(solve_refining(free.task, free.grid, free.guess, options, observer));
  if (least.result.status == PlanStatus::kStalled) return from_afar();
  if (least.result.status != PlanStatus::kSolved) return least;
  if (given < least.trajectory.durations.front()) {
    least.result.status = PlanStatus::kInfeasible;
    least.too_short = true;
    return least;
  }
  PlannedTrajectory planned = counted(
      solve_beside(problem.task, problem.grid, stretched(least.trajectory, problem.grid), options, observer));
  return ended(planned) ? planned : from_afar();
}

}  // namespace armtune
