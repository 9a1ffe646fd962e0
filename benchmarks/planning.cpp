// Measures how the time of planning grows with the number of knots. It plans a UR10 target switch in the
// least time on grids of 200 to 20,000 knots, each with all its coarser grids. It prints the exponent from
// each grid to the next, and that of a least-squares line through the logarithms.

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "tuner/planning/tasks/solve_plan.hpp"
#include "tuner/run/run_folder.hpp"

namespace {

struct Timing {
  double knots = 0.0;
  double seconds = 0.0;
};

double seconds_of(const armtune::internal::PlanTask& task, armtune::internal::PlannedTrajectory& planned) {
  const auto began = std::chrono::steady_clock::now();
  const armtune::internal::PlanProblem problem = armtune::internal::plan_problem(task);
  planned = armtune::internal::solve_plan(problem);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

double exponent(const std::vector<Timing>& timings) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Timing& t : timings) {
    const double a = std::log(t.knots);
    const double b = std::log(t.seconds);
    n += 1.0;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 3;
  armtune::internal::PlanTask task = armtune::internal::load_plan_task("ur10_switch");
  std::vector<Timing> timings;
  timings.reserve(8);
  fmt::print("{}\n", armtune::internal::measured_with());
  fmt::print("{}: the best of {}\n{:>8} {:>10} {:>12} {:>10} {:>12} {:>14} {:>12} {:>12}\n", task.name,
             repeats, "knots", "seconds", "us a knot", "exponent", "duration s", "interior steps",
             "violation", "KKT");
  for (const int knots : {200, 500, 1000, 2000, 5000, 10000, 20000}) {
    task.knots = knots;
    double best = INFINITY;
    armtune::internal::PlannedTrajectory planned;
    for (int repeat = 0; repeat < repeats; ++repeat) best = std::min(best, seconds_of(task, planned));
    const auto& last = planned.result.last;
    if (planned.result.status != armtune::internal::PlanStatus::kSolved) {
      fmt::print("{} knots: not solved\n", knots);
      return 1;
    }
    timings.push_back({static_cast<double>(knots), best});
    const std::string from_before =
        timings.size() < 2 ? "" : fmt::format("{:.2f}", exponent({timings.end() - 2, timings.end()}));
    fmt::print("{:8} {:10.3f} {:12.1f} {:>10} {:12.6f} {:14} {:12.1e} {:12.1e}\n", knots, best,
               1e6 * best / knots, from_before, planned.trajectory.durations.front(),
               planned.interior_iterations, last.violation,
               std::max(last.stationarity, last.complementarity));
    std::fflush(stdout);
  }
  fmt::print("time ~ knots^{:.2f} from 200 to 20000 knots\n", exponent(timings));
  return 0;
}
