// Measures the cost of a cell: the time of a control period in rollouts of one arm, in armtune's own dynamics
// and outside of lanes. It compares rollouts without any distances with rollouts that know at every period
// the smallest distances of the links from each other, from the floor, from two parts at rest and from a
// moving part. The two are run in turn, and the medians are compared. The goal is a ratio of at most 1.3.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "core/control/laws/starting_gains.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/default_task.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/run/run_folder.hpp"

namespace {

using namespace armtune::internal;
using Clock = std::chrono::steady_clock;

CellPart part(const char* name, const Solid& solid, const Vec3& center) {
  return {name, solid, Mat3::Identity(), Path{center, 0.0, 0.0, {}}};
}

/// Returns a cell with a table below the task, a post beside it and a ball that passes.
Cell cell_about(const Vec3& center) {
  Cell cell;
  cell.floor = 0.0;
  cell.parts.push_back(part("table", box({0.8, 0.8, 0.05}), {center.x(), center.y(), 0.02}));
  cell.parts.push_back(part("post", cylinder(0.05, 1.0), center + Vec3(0.0, 0.5, 0.0)));
  cell.parts.push_back(
      {"ball", sphere(0.05), Mat3::Identity(),
       Path{center + Vec3(0.35, 0.0, 0.1), 0.9, 0.0, {{1, Vec3(0.0, 0.5, 0.0), Vec3(0.1, 0.0, 0.0)}}}});
  return cell;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double seconds_per_period(const std::shared_ptr<const PreparedScenario>& prepared, const Gains& gains) {
  const auto began = Clock::now();
  Rollout(prepared, Stepper::kMidpoint, Engine::kNative).run(gains);
  return std::chrono::duration<double>(Clock::now() - began).count() / prepared->scenario.periods();
}

}  // namespace

int main() {
  constexpr int kBlocks = 11;
  fmt::print("{}\n", measured_with());
  fmt::print(
      "Time of a control period, median of {} rollouts on one thread. The goal is a ratio of at most 1.3.\n"
      "Pairs of bodies that are watched in the cell: links, floor, table, post and moving ball.\n\n",
      kBlocks);
  fmt::print("{:<10}{:>8}{:>20}{:>20}{:>20}\n", "arm", "pairs", "without [us]", "in a cell [us]", "ratio");
  for (const char* name : {"ur5e", "fr3", "gen3_7", "ur10"}) {
    const auto robot = load_robot(name);
    const DefaultTask task = default_task(robot);
    const Gains gains = starting_gains(*robot, task.scenario.start_position, task.goal, task.manipulability);
    Scenario scenario = task.scenario;
    scenario.clearance.reset();
    const auto without = std::make_shared<const PreparedScenario>(scenario);
    scenario.clearance = std::make_shared<const ClearanceModel>(robot, cell_about(scenario.path.center));
    const auto within = std::make_shared<const PreparedScenario>(scenario);
    std::vector<double> times_without;
    std::vector<double> times_within;
    for (int block = 0; block < kBlocks; ++block) {
      times_without.push_back(seconds_per_period(without, gains));
      times_within.push_back(seconds_per_period(within, gains));
    }
    fmt::print("{:<10}{:>8}{:>20.3f}{:>20.3f}{:>20.3f}\n", name, scenario.clearance->pairs().size(),
               1e6 * median(times_without), 1e6 * median(times_within),
               median(times_within) / median(times_without));
  }
  return 0;
}
