#include "tuner/planning/refining_solver.hpp"

#include <algorithm>
#include <cmath>

namespace armtune {
namespace {

constexpr int kCoarsest = 24;  // intervals of the longest phase
constexpr int kFactor = 3;     // from one grid to the next
// Multipliers near the edge of what is feasible grow without bound beside the objective, and a violation is
// dear only so far: before a task is called infeasible the objective must weigh next to nothing.
constexpr double kWeights[] = {1.0, 1e-6};
constexpr double kWorthOfGuess = 5e-3;  // objective of a guess beside the limits, weighed,
constexpr double kWorthOfPlan = 0.02;   // and of what is found from there

/// Intervals of the longest phase on each grid, the finest first.
std::vector<int> sizes_of(const TimeGrid& grid) {
  std::vector<int> sizes{0};
  for (const Phase& phase : grid.phases) sizes.front() = std::max(sizes.front(), phase.intervals);
  while (sizes.back() > kFactor * kCoarsest) sizes.push_back(sizes.back() / kFactor);
  return sizes;
}

/// Every phase with its part of `longest` intervals, at least 4 and never more than wanted.
TimeGrid coarser(const TimeGrid& grid, int longest, int wanted) {
  TimeGrid coarse = grid;
  for (Phase& phase : coarse.phases)
    phase.intervals =
        std::min(phase.intervals,
                 std::max(4, static_cast<int>(static_cast<long>(phase.intervals) * longest / wanted)));
  return coarse;
}

/// The task with its whole objective times `weight`.
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

/// Whether only the smoothness is to gain: then the objective's size says nothing.
bool smoothest(const TrajectoryTask& task) {
  const auto free = [](const Phase& phase) { return phase.free; };
  const auto costs = [](const KnotTerm& term) { return term.cost; };
  return std::none_of(task.grid.phases.begin(), task.grid.phases.end(), free) &&
         std::none_of(task.terms.begin(), task.terms.end(), costs);
}

/// The observer hears of the grid's knots, too.
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
    // The dynamics are kept at any price: a guess that breaks them would have to move far, however short its
    // steps are to be. A coarser grid's solution keeps them nearly, and its accelerations may well have
    // jumps.
    if (!solved) make_continuous(from);
    planned.result = solve(*program, program->unknowns(from), y, here, with_knots(level, observer));
    planned.interior_iterations += planned.result.last.interior_iterations;
    planned.trajectory = program->trajectory(planned.result.z);
    planned.program = program;
    if (planned.result.status == PlanStatus::kInterrupted) break;
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
  for (const double weight : kWeights) {
    PlannedTrajectory now = refine(weighted(task, weight), grid, guess, options, observer);
    steps += now.interior_iterations;
    // Coming to no end says nothing against what was found before.
    if (now.result.status == PlanStatus::kStalled && planned.result.status == PlanStatus::kInfeasible) break;
    planned = std::move(now);
    planned.weight = weight;
    if (planned.result.status == PlanStatus::kSolved && weight < 1.0 && !smoothest(task(grid))) {
      // Feasible: from there with all that the objective weighs, and multipliers to match, so that violations
      // are dear enough from the beginning.
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
  return planned;
}

PlannedTrajectory solve_beside(const TaskOnGrid& task, const TimeGrid& grid, const Trajectory& guess,
                               const SequentialQuadraticOptions& options, const PlanObserver& observer) {
  PlannedTrajectory planned;
  Trajectory from = guess;
  make_continuous(from);
  planned.program = std::make_shared<TrajectoryProgram>(task(grid));
  planned.result.z = planned.program->unknowns(from);
  double objective = planned.program->objective(planned.result.z);
  int steps = 0;
  // The guess may be far from smooth: once more by what the objective is found to be.
  for (const double worth : {kWorthOfGuess, kWorthOfPlan}) {
    PlannedTrajectory now;
    now.weight = std::min(1.0, worth / objective);
    now.program = std::make_shared<TrajectoryProgram>(weighted(task, now.weight)(grid));
    const Eigen::VectorXd multipliers = planned.result.multipliers * (now.weight / planned.weight);
    now.result = solve(*now.program, planned.result.z, multipliers, options, with_knots(grid, observer));
    steps += now.result.last.interior_iterations;
    // Coming to no end says nothing against what was found before.
    const bool first = planned.result.multipliers.size() == 0;
    if (!first && now.result.status != PlanStatus::kSolved && now.result.status != PlanStatus::kInterrupted)
      break;
    planned = std::move(now);
    if (planned.result.status != PlanStatus::kSolved) break;
    objective = planned.objective();
  }
  planned.trajectory = planned.program->trajectory(planned.result.z);
  planned.interior_iterations = steps;
  return planned;
}

}  // namespace armtune
