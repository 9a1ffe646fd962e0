#include "tuner/planning/refining_solver.hpp"

#include <algorithm>

namespace armtune {
namespace {

constexpr int kCoarsest = 24;  // intervals of the longest phase
constexpr int kFactor = 3;     // from one grid to the next

/// Every phase with its part of `longest` intervals, at least 4 and never more than wanted.
TimeGrid coarser(const TimeGrid& grid, int longest, int wanted) {
  TimeGrid coarse = grid;
  for (Phase& phase : coarse.phases)
    phase.intervals =
        std::min(phase.intervals,
                 std::max(4, static_cast<int>(static_cast<long>(phase.intervals) * longest / wanted)));
  return coarse;
}

}  // namespace

PlannedTrajectory solve_refining(const TaskOnGrid& task, const TimeGrid& grid, const Trajectory& guess,
                                 const SequentialQuadraticOptions& options, const PlanObserver& observer) {
  int wanted = 0;
  for (const Phase& phase : grid.phases) wanted = std::max(wanted, phase.intervals);
  std::vector<int> sizes{wanted};
  while (sizes.back() > kFactor * kCoarsest) sizes.push_back(sizes.back() / kFactor);

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
    if (planned.program && planned.result.status == PlanStatus::kSolved) {
      y = program->multipliers_from(*planned.program, planned.result.multipliers);
      here.damping = planned.result.last.damping;
    }
    const PlanObserver with_knots = [&](SequentialQuadraticProgress at) {
      at.knots = level.knots();
      return !observer || observer(at);
    };
    planned.result =
        solve(*program, program->unknowns(on_grid(planned.trajectory, level)), y, here, with_knots);
    planned.interior_iterations += planned.result.last.interior_iterations;
    planned.trajectory = program->trajectory(planned.result.z);
    planned.program = program;
    if (planned.result.status == PlanStatus::kInterrupted) break;
  }
  return planned;
}

}  // namespace armtune
