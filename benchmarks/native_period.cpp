// Measures closed-loop rollouts in armtune's own dynamics: how many times faster than real time one processor
// simulates one arm alone, and several side by side with bit-identical results. Measured in turn.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

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

}  // namespace

int main() {
  constexpr int kBlocks = 9;
  fmt::print("{}\n", measured_with());
  fmt::print("{:<26}{:>8}{:>16}{:>16}{:>14}\n", "scenario", "arms", "us per period", "x real time",
             "of alone");
  for (const char* name : {"moving_target", "realistic_obstacle_pass", "realistic_target_switch"}) {
    const auto prepared = std::make_shared<const PreparedScenario>(load_scenario(name));
    const Scenario& scenario = prepared->scenario;
    const Gains gains = load_gains("published", joint_names(*scenario.robot));
    std::vector<int> widths = {1};
    for (int w = 2; w <= most_lanes(best_processor()); w *= 2) widths.push_back(w);
    std::vector<std::vector<double>> times(widths.size());  // per arm and period [s]
    for (int block = 0; block < kBlocks; ++block) {
      for (std::size_t i = 0; i < widths.size(); ++i) {
        const int arms = widths[i];
        const auto began = Clock::now();
        if (arms == 1) {
          Rollout(prepared, Stepper::kMidpoint, Engine::kNative).run(gains);
        } else {
          RolloutLanes lanes(lane_kind(scenario, Stepper::kMidpoint, scenario.obstacles.size()), arms);
          for (int lane = 0; lane < arms; ++lane) lanes.start(lane, {prepared, gains});
          while (lanes.busy() > 0) lanes.step([](int, RolloutResult&&) {});
        }
        times[i].push_back(seconds_since(began) / arms / scenario.periods());
      }
    }
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const double each = median(times[i]);
      fmt::print("{:<26}{:>8}{:>16.3f}{:>16.0f}{:>14.2f}\n", i == 0 ? name : "", widths[i], 1e6 * each,
                 scenario.control_period / each, each / median(times[0]));
    }
  }
  return 0;
}
