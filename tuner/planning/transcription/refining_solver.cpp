#include "tuner/planning/transcription/refining_solver.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

constexpr int kCoarsest = 24;  // coarser grids have at least this many intervals in their longest phase
constexpr int kGridRatio = 3;  // ratio of the intervals of one grid and the next coarser one
// If a task is barely feasible, its multipliers grow without bound relative to the objective, but the penalty
// on violations is bounded. A task is called infeasible only after a solve with this weight of the objective.
constexpr double kLeastWeight = 1e-6;
// If smoothness is the only objective, its scale is arbitrary. The weighted objective shall be
constexpr double kWorthFromAfar = 20.0;  // at most this at a guess far from the solution,
constexpr double kWorthOfGuess = 5e-3;   // at most this at a guess that nearly satisfies the limits,
constexpr double kWorthOfPlan = 0.02;    // and about this at the solution. The weight is raised
constexpr double kMoreWeight = 1e3;      // by at most this factor at a time.

/// Returns the number of intervals of the longest phase on each grid, the finest grid first.
std::vector<int> sizes_of(const TimeGrid& grid) {
  std::vector<int> sizes{0};
  for (const Phase& phase : grid.phases) sizes.front() = std::max(sizes.front(), phase.intervals);
  while (sizes.back() > kGridRatio * kCoarsest) sizes.push_back(sizes.back() / kGridRatio);
  return sizes;
}

/// Returns the grid with the intervals of every phase multiplied by longest / wanted. A phase keeps at least
/// 4 intervals, or all if it has fewer.
TimeGrid coarser(const TimeGrid& grid, int longest, int wanted) {
  TimeGrid coarse = grid;
  for (Phase& phase : coarse.phases)
    phase.intervals =
        std::min(phase.intervals,
                 std::max(4, static_cast<int>(static_cast<long>(phase.intervals) * longest / wanted)));
  return coarse;
}

/// Returns the task with its whole objective multiplied by `weight`.
TaskOnGrid weighted(const TaskOnGrid& task, double weight) {
  if (weight == 1.0) return task;
  return [task, weight](const TimeGrid& grid) {
    TrajectoryTask made = task(grid);
    made.duration_cost *= weight;
    made.smoothness.acceleration *= weight;
    made.smoothness.jerk *= weight;
    for (KnotTerm& term : made.terms) {
      if (!term.cost) continue;
      const auto rows = static_cast<Eigen::Index>(term.rows.size());
      term.evaluate = [evaluate = term.evaluate, rows, root = std::sqrt(weight)](const Knot& knot,
                                                                                 const KnotRows& out) {
        evaluate(knot, out);
        Eigen::Map<Eigen::VectorXd>(out.value, rows) *= root;
        for (double* by : {out.by_q, out.by_qd, out.by_qdd}) {
          if (by != nullptr) Eigen::Map<Eigen::VectorXd>(by, rows * out.columns) *= root;
        }
        if (out.by_time != nullptr) Eigen::Map<Eigen::VectorXd>(out.by_time, rows) *= root;
      };
    }
    return made;
  };
}

/// True if smoothness is the only objective. The size of the objective then has no meaning.
bool smoothest(const TrajectoryTask& task) {
  const auto free = [](const Phase& phase) { return phase.free; };
  const auto costs = [](const KnotTerm& term) { return term.cost; };
  return std::none_of(task.grid.phases.begin(), task.grid.phases.end(), free) &&
         std::none_of(task.terms.begin(), task.terms.end(), costs);
}

/// Returns the weight that makes the objective at the guess kWorthFromAfar, but at most 1. Returns 1 unless
/// smoothness is the only objective.
double first_weight(const TaskOnGrid& task, const TimeGrid& grid, const Trajectory& guess) {
  TrajectoryTask made = task(grid);
  if (!smoothest(made)) return 1.0;
  Trajectory from = on_grid(guess, grid);
  make_continuous(from);
  TrajectoryProgram program(std::move(made));
  return std::min(1.0, kWorthFromAfar / program.objective(program.unknowns(from)));
}

/// Returns an observer that also receives the number of the grid's knots.
PlanObserver with_knots(const TimeGrid& grid, const PlanObserver& observer) {
  return [knots = grid.knots(), &observer](SequentialQuadraticProgress at) {
    at.knots = knots;
    return !observer || observer(at);
  };
}

PlannedTrajectory refine(const TaskOnGrid& task, const TimeGrid& grid, const Trajectory& guess,
                         const SequentialQuadraticOptions& options, const PlanObserver& observer) {
  const std::vector<int> sizes = sizes_of(grid);
  const int wanted = sizes.front();
  PlannedTrajectory planned;
  planned.trajectory = guess;
  Eigen::VectorXd y;
  for (auto size = sizes.rbegin(); size != sizes.rend(); ++size) {
    const bool last = *size == wanted;
    const TimeGrid level = last ? grid : coarser(grid, *size, wanted);
    auto program = std::make_shared<TrajectoryProgram>(task(level));
    SequentialQuadraticOptions here = options;
    if (!last) {
      here.stationarity = std::max(options.stationarity, 1e-3);
      here.violation = std::max(options.violation, 1e-4);
      here.complementarity = std::max(options.complementarity, 1e-5);
    }
    y.resize(0);
    const bool solved = planned.program && planned.result.status == PlanStatus::kSolved;
    if (solved) {
      y = program->multipliers_from(*planned.program, planned.result.multipliers);
      here.damping = planned.result.last.damping;
    }
    Trajectory from = on_grid(solved ? planned.trajectory : guess, level);
    // The equations of continuity between knots are hard. If the guess violates them, the first step must be
    // long, in spite of the damping. A coarser grid's solution nearly satisfies them. It is kept unchanged,
    // because its accelerations may have jumps.
    if (!solved) make_continuous(from);
    planned.result = solve(*program, program->unknowns(from), y, here, with_knots(level, observer));
    planned.interior_iterations += planned.result.last.interior_iterations;
    planned.trajectory = program->trajectory(planned.result.z);
    planned.program = program;
    if (planned.result.status == PlanStatus::kInterrupted) break;
  }
  return planned;
}

/// Solves again with increasing weights of the objective, if the weight was too small for the solution to
/// minimise the objective.
PlannedTrajectory weighed_in(PlannedTrajectory planned, const TaskOnGrid& task, const TimeGrid& grid,
                             const SequentialQuadraticOptions& options, const PlanObserver& observer) {
  while (planned.result.status == PlanStatus::kSolved) {
    const double wanted = std::min(1.0, kWorthOfPlan / planned.objective());
    if (planned.weight > 0.5 * wanted) break;
    PlannedTrajectory now;
    now.weight = std::min(wanted, kMoreWeight * planned.weight);
    now.program = std::make_shared<TrajectoryProgram>(weighted(task, now.weight)(grid));
    now.result =
        solve(*now.program, planned.result.z, planned.result.multipliers * (now.weight / planned.weight),
              options, with_knots(grid, observer));
    now.interior_iterations = planned.interior_iterations + now.result.last.interior_iterations;
    now.trajectory = now.program->trajectory(now.result.z);
    planned.interior_iterations = now.interior_iterations;
    // If this solve fails, the solution from before is still valid.
    if (now.result.status != PlanStatus::kSolved && now.result.status != PlanStatus::kInterrupted) break;
    planned = std::move(now);
  }
  return planned;
}

}  // namespace

TimeGrid coarsest(const TimeGrid& grid) {
  const std::vector<int> sizes = sizes_of(grid);
  return coarser(grid, sizes.back(), sizes.front());
}

PlannedTrajectory solve_refining(const TaskOnGrid& task, const TimeGrid& grid, const Trajectory& guess,
                                 const SequentialQuadraticOptions& options, const PlanObserver& observer) {
  PlannedTrajectory planned;
  int steps = 0;
  const double first = first_weight(task, coarsest(grid), guess);
  for (const double weight : {first, kLeastWeight * first}) {
    PlannedTrajectory now = refine(weighted(task, weight), grid, guess, options, observer);
    steps += now.interior_iterations;
    // A solve that stalls does not refute the result from before.
    if (now.result.status == PlanStatus::kStalled && planned.result.status == PlanStatus::kInfeasible) break;
    planned = std::move(now);
    planned.weight = weight;
    if (planned.result.status == PlanStatus::kSolved && weight < first && !smoothest(task(grid))) {
      // The task is feasible. Continue from this solution with the full objective. The multipliers are scaled
      // accordingly, so that the penalties on violations are high enough from the beginning.
      const auto program = std::make_shared<TrajectoryProgram>(task(grid));
      planned.result = solve(*program, planned.result.z, planned.result.multipliers / weight, options,
                             with_knots(grid, observer));
      planned.program = program;
      planned.weight = 1.0;
      planned.trajectory = program->trajectory(planned.result.z);
      steps += planned.result.last.interior_iterations;
      if (planned.result.status == PlanStatus::kInfeasible) planned.result.status = PlanStatus::kStalled;
      break;
    }
    if (planned.result.status == PlanStatus::kSolved || planned.result.status == PlanStatus::kInterrupted)
      break;
  }
  planned.interior_iterations = steps;
  return weighed_in(std::move(planned), task, grid, options, observer);
}

PlannedTrajectory solve_beside(const TaskOnGrid& task, const TimeGrid& grid, const Trajectory& guess,
                               const SequentialQuadraticOptions& options, const PlanObserver& observer) {
  PlannedTrajectory planned;
  Trajectory from = guess;
  make_continuous(from);
  TrajectoryProgram whole(task(grid));
  const Eigen::VectorXd z = whole.unknowns(from);
  planned.weight = std::min(1.0, kWorthOfGuess / whole.objective(z));
  planned.program = std::make_shared<TrajectoryProgram>(weighted(task, planned.weight)(grid));
  planned.result = solve(*planned.program, z, {}, options, with_knots(grid, observer));
  planned.interior_iterations = planned.result.last.interior_iterations;
  planned.trajectory = planned.program->trajectory(planned.result.z);
  return weighed_in(std::move(planned), task, grid, options, observer);
}

}  // namespace armtune::internal
