// Compares the planner's own solver with Ipopt on the bundled planning tasks and on random ones. Both get the
// same TrajectoryProgram on the same grid, the same initial guess, the same Jacobians and Hessians, and about
// the same tolerances. Times are processor times, the best of several runs. With `whole`, it measures
// solve_plan instead, which begins on coarse grids. benchmark_ipopt_inside is the same program with Ipopt in
// place of the planner's solver.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "random_plans.hpp"
#include "tuner/planning/solver/violation_price.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"
#include "tuner/run/run_folder.hpp"
#ifndef ARMTUNE_IPOPT_INSIDE
#include "ipopt_solver.hpp"
#endif

namespace armtune::internal {
namespace {

using Eigen::VectorXd;

constexpr double kMostSeconds = 60.0;  // for one solve
constexpr double kSame = 1e-4;         // largest relative difference of optima that count as equal
constexpr double kNought = 1e-2;       // least value to which that difference is relative
constexpr double kKept = 1e-6;         // largest violation, relative to the limit, that counts as none

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Outcome {
  PlanStatus status = PlanStatus::kStalled;
  std::string word;
  double seconds = INFINITY;
  int iterations = 0;
  double objective = NAN;
  double violation = NAN;

  bool solved() const { return status == PlanStatus::kSolved && violation <= kKept; }
};

std::string word_of(PlanStatus status) {
  switch (status) {
    case PlanStatus::kSolved:
      return "solved";
    case PlanStatus::kInfeasible:
      return "infeasible";
    case PlanStatus::kStalled:
      return "stalled";
    case PlanStatus::kInterrupted:
      return "time";
  }
  return {};
}

PlanObserver until_late() {
  return [end = processor_seconds() + kMostSeconds](const SequentialQuadraticProgress&) {
    return processor_seconds() < end;
  };
}

/// Returns the outcome of several runs that end alike, with the shortest of their times.
Outcome best_of(int repeats, const std::function<Outcome()>& run) {
  Outcome best;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const double began = processor_seconds();
    Outcome outcome = run();
    outcome.seconds = std::min(best.seconds, processor_seconds() - began);
    best = outcome;
    if (outcome.seconds > 0.1 * kMostSeconds) break;
  }
  return best;
}

#ifdef ARMTUNE_IPOPT_INSIDE
constexpr const char* kSolver = "Ipopt in the solver's place";
#else
constexpr const char* kSolver = "our solver";

/// Computes objective and largest violation at z, in the same way for both solvers.
void judge(TrajectoryProgram& program, const VectorXd& z, Outcome& outcome) {
  VectorXd residual, row;
  program.evaluate(z, residual, row);
  outcome.objective = program.cost.dot(z) + 0.5 * residual.squaredNorm();
  outcome.violation = 0.0;
  for (Eigen::Index i = 0; i < row.size(); ++i)
    outcome.violation = std::max(outcome.violation, violation(program.bounds, i, row[i]));
}

/// Compares the results of two solvers on many tasks.
struct Score {
  int tasks = 0, ours = 0, theirs = 0, both = 0, same = 0, better = 0, worse = 0;
  double our_seconds = 0.0, their_seconds = 0.0;  ///< sums over tasks that both solved
  std::vector<double> ratios;

  void add(const Outcome& us, const Outcome& them) {
    ++tasks;
    ours += us.solved() ? 1 : 0;
    theirs += them.solved() ? 1 : 0;
    if (!us.solved() || !them.solved()) return;
    ++both;
    const double gap = (us.objective - them.objective) / std::max(std::abs(them.objective), kNought);
    same += std::abs(gap) <= kSame ? 1 : 0;
    better += gap < -kSame ? 1 : 0;
    worse += gap > kSame ? 1 : 0;
    our_seconds += us.seconds;
    their_seconds += them.seconds;
    ratios.push_back(them.seconds / us.seconds);
  }
  void print(const char* name) {
    std::sort(ratios.begin(), ratios.end());
    double logs = 0.0;
    for (const double ratio : ratios) logs += std::log(ratio);
    fmt::print(
        "{}: {} tasks; ours solves {}, Ipopt {}, both {}; of those the optimum is equal {} times, ours is "
        "better {} "
        "times, Ipopt's {} times; seconds on those: ours {:.2f}, Ipopt {:.2f}; Ipopt's time over ours: "
        "geometric mean {:.2f}, median {:.2f}, {:.2f} .. {:.2f}\n",
        name, tasks, ours, theirs, both, same, better, worse, our_seconds, their_seconds,
        ratios.empty() ? NAN : std::exp(logs / static_cast<double>(ratios.size())),
        ratios.empty() ? NAN : ratios[ratios.size() / 2], ratios.empty() ? NAN : ratios.front(),
        ratios.empty() ? NAN : ratios.back());
  }
};

void print(const Outcome& outcome) {
  fmt::print(" | {:>10} {:8.3f} {:5} {:15.9g} {:8.1e}", outcome.word, outcome.seconds, outcome.iterations,
             outcome.objective, outcome.violation);
}

Outcome by_ipopt(TrajectoryProgram& program, const VectorXd& z, int repeats) {
  return best_of(repeats, [&] {
    IpoptOptions options;
    options.max_seconds = kMostSeconds;
    const IpoptRun run = solve_by_ipopt(program, z, {}, options);
    Outcome outcome{run.status, run.word, 0.0, run.iterations};
    judge(program, run.z, outcome);
    return outcome;
  });
}

void compare_on_one_grid(const std::string& name, const PlanProblem& problem, int repeats, Score& score) {
  TrajectoryProgram program(problem.task(problem.grid));
  Trajectory guess = on_grid(problem.guess, problem.grid);
  make_continuous(guess);
  const VectorXd z = program.unknowns(guess);
  const Outcome ours = best_of(repeats, [&] {
    const SequentialQuadraticResult result = solve(program, z, {}, {}, until_late());
    Outcome outcome{result.status, word_of(result.status), 0.0, result.last.interior_iterations};
    judge(program, result.z, outcome);
    return outcome;
  });
  const Outcome theirs = by_ipopt(program, z, repeats);
  score.add(ours, theirs);
  fmt::print("{:<24} {:6} {:6}", name, program.variables(), program.rows.rows());
  print(ours);
  print(theirs);
  fmt::print("\n");
  std::fflush(stdout);
}
#endif

void measure_whole(const std::string& name, const PlanProblem& problem, int repeats) {
  const Outcome whole = best_of(repeats, [&] {
    const PlannedTrajectory planned = solve_plan(problem, {}, until_late());
    const PlanStatus status = planned.result.status;
    Outcome outcome{status,
                    word_of(status),
                    0.0,
                    planned.interior_iterations,
                    planned.objective(),
                    planned.result.last.violation};
    return outcome;
  });
  fmt::print("{:<24} {:>10} {:8.3f} {:5} {:15.9g} {:8.1e}\n", name, whole.word, whole.seconds,
             whole.iterations, whole.objective, whole.violation);
  std::fflush(stdout);
}

int run(bool whole, int random_tasks, int repeats, std::uint64_t seed) {
  constexpr int kKnots = 60;  // knots of a random task
  std::vector<RandomPlan> plans;
  for (const char* name : {"ur10_clear_of_obstacles", "ur10_fastest_circle", "ur10_lap",
                           "ur10_least_gaze_error", "ur10_move", "ur10_return", "ur10_switch"}) {
    PlanTask task = load_plan_task(name);
    PlanProblem problem = plan_problem(task);
    plans.push_back({std::move(task), std::move(problem)});
  }
  const std::size_t bundled = plans.size();
  for (RandomPlan& plan : random_plans(random_tasks, kKnots, seed)) plans.push_back(std::move(plan));
  fmt::print("{}{} bundled tasks, {} random ones (seed {}, {} knots); the best of {}\n\n", measured_with(),
             bundled, random_tasks, seed, kKnots, repeats);
  if (whole) {
    fmt::print("solve_plan, by way of coarse grids, with {}\n{:<24} {:>10} {:>8} {:>5} {:>15} {:>8}\n",
               kSolver, "task", "end", "seconds", "steps", "objective", "violated");
    for (const RandomPlan& plan : plans) measure_whole(plan.task.name, plan.problem, repeats);
    return 0;
  }
#ifndef ARMTUNE_IPOPT_INSIDE
  fmt::print(
      "one grid, one guess; per solver: how it ended, seconds, linear systems or iterations, objective, "
      "largest violation\n{:<24} {:>6} {:>6} | {:^50} | {:^50}\n",
      "task", "z", "rows", "ours", "Ipopt");
  Score of_bundled, of_random;
  for (std::size_t i = 0; i < plans.size(); ++i)
    compare_on_one_grid(plans[i].task.name, plans[i].problem, repeats, i < bundled ? of_bundled : of_random);
  fmt::print("\n");
  of_bundled.print("bundled");
  of_random.print("random");
#endif
  return 0;
}

}  // namespace
}  // namespace armtune::internal

int main(int argc, char** argv) {
  const bool whole = argc > 1 && std::string(argv[1]) == "whole";
  const auto number = [&](int place, int otherwise) {
    return argc > place ? std::atoi(argv[place]) : otherwise;
  };
  const int first = whole ? 2 : 1;
  return armtune::internal::run(whole, number(first, 50), number(first + 1, 3),
                                static_cast<std::uint64_t>(number(first + 2, 1)));
}
