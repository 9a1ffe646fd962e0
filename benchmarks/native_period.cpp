// Measures closed-loop rollouts in armtune's own dynamics: how many times faster than real time one processor
// simulates one arm alone, and several side by side with bit-identical results. The first table compares
// numbers of arms under the adaptive law, the second all controllers with one arm and with as many arms as
// the processor has lanes. The rows of a scenario or of a controller are measured in turn.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "sim/lanes/rollout_lanes.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/run/run_folder.hpp"

namespace {

using namespace armtune::internal;
using Clock = std::chrono::steady_clock;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double seconds_since(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

constexpr int kBlocks = 9;
using Prepared = std::shared_ptr<const PreparedScenario>;

/// Simulates the scenario with as many arms side by side, or with one arm alone. Returns the wall time per
/// arm and control period [s].
double measure(const Prepared& prepared, const Gains& gains, int arms) {
  const Scenario& scenario = prepared->scenario;
  const auto began = Clock::now();
  double simulated = 0.0;  // [s]
  if (arms == 1) {
    simulated = Rollout(prepared, Stepper::kMidpoint, Engine::kNative).run(gains).end_time;
  } else {
    RolloutLanes lanes(
        lane_kind(scenario, Stepper::kMidpoint, scenario.obstacles.size(), lane_law(gains).value()), arms);
    for (int lane = 0; lane < arms; ++lane) lanes.start(lane, {prepared, gains});
    while (lanes.busy() > 0) lanes.step([&](int, RolloutResult&& result) { simulated += result.end_time; });
  }
  return seconds_since(began) * scenario.control_period / simulated;
}

/// Returns the median time of each number of arms.
std::vector<double> measure_in_turn(const Prepared& prepared, const Gains& gains,
                                    const std::vector<int>& widths) {
  std::vector<std::vector<double>> times(widths.size());
  for (int block = 0; block < kBlocks; ++block) {
    for (std::size_t i = 0; i < widths.size(); ++i) times[i].push_back(measure(prepared, gains, widths[i]));
  }
  std::vector<double> medians;
  for (const std::vector<double>& of_width : times) medians.push_back(median(of_width));
  return medians;
}

void print_scenarios() {
  fmt::print("{:<26}{:>8}{:>16}{:>16}{:>14}\n", "scenario", "arms", "us per period", "x real time",
             "of alone");
  std::vector<int> widths = {1};
  for (int w = 2; w <= most_lanes(best_processor()); w *= 2) widths.push_back(w);
  for (const char* name : {"moving_target", "realistic_obstacle_pass", "realistic_target_switch"}) {
    const auto prepared = std::make_shared<const PreparedScenario>(load_scenario(name));
    const Scenario& scenario = prepared->scenario;
    const std::vector<double> times =
        measure_in_turn(prepared, load_gains("published", joint_names(*scenario.robot)), widths);
    for (std::size_t i = 0; i < widths.size(); ++i) {
      fmt::print("{:<26}{:>8}{:>16.3f}{:>16.0f}{:>14.2f}\n", i == 0 ? name : "", widths[i], 1e6 * times[i],
                 scenario.control_period / times[i], times[i] / times[0]);
    }
  }
}

/// The controllers track the same path, with their start gains and the arm's model.
void print_controllers() {
  Scenario scenario = load_scenario("moving_target");
  scenario.theta = {};
  scenario.theta.model_scale = 1.0;
  const auto prepared = std::make_shared<const PreparedScenario>(scenario);
  const Gains published = load_gains("published", joint_names(*scenario.robot));
  const JointVector goal = in_si(*scenario.robot, with_goal(published, scenario).joint_space_goal);
  const int lanes = most_lanes(best_processor());
  fmt::print("\n{:<38}{:>24}{:>24}{:>8}\n", "controller, simulated s per s:", "alone",
             fmt::format("in {} lanes", lanes), "ratio");
  for (const ControllerKind* kind : controller_kinds()) {
    const Gains gains = convert_gains(*kind, published, *scenario.robot, goal);
    const std::vector<double> times = measure_in_turn(prepared, gains, {1, lanes});
    const double alone = scenario.control_period / times[0];
    const double several = scenario.control_period / times.back();
    fmt::print("{:<38}{:>24.0f}{:>24.0f}{:>8.2f}\n", kind->name, alone, several, several / alone);
  }
}

}  // namespace

int main() {
  fmt::print("{}\n", measured_with());
  print_scenarios();
  print_controllers();
  return 0;
}
