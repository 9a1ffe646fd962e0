// Runs a fixed piece of work for an instruction counter: one rollout of the published gains, nothing else.
// The difference between two runs of different durations is the cost of the additional control periods.

#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <string>

#include "sim/lanes/rollout_lanes.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"

namespace {

using namespace armtune::internal;

/// Runs two arms side by side, with the kernels that every processor supports.
int run_lanes(const Scenario& scenario, const Gains& gains) {
  const auto prepared = std::make_shared<const PreparedScenario>(scenario);
  RolloutLanes lanes(lane_kind(scenario, Stepper::kMidpoint, scenario.obstacles.size()), 2, Processor::kAny);
  for (int lane = 0; lane < 2; ++lane) lanes.start(lane, {prepared, gains});
  bool whole = true;
  while (lanes.busy() > 0) {
    lanes.step([&](int, RolloutResult&& result) { whole = whole && result.end_time == scenario.duration; });
  }
  return whole ? 0 : 1;
}

int run(const char* engine, const char* name, double seconds) {
  Scenario scenario = load_scenario(name);
  scenario.duration = seconds;
  scenario.clearance.reset();  // what a cell costs is measured by cell_period.cpp
  const Gains gains = load_gains("published", joint_names(*scenario.robot));
  if (engine == std::string("lanes")) return run_lanes(scenario, gains);
  Rollout rollout(scenario, Stepper::kMidpoint, engine_from_name(engine));
  const RolloutResult result = rollout.run(gains);
  fmt::print("{} periods, {}\n", scenario.periods(), armtune::internal::name(result.status));
  return result.end_time == seconds ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    fmt::print(stderr, "Usage: benchmark_work simbody|native|lanes SCENARIO SECONDS\n");
    return 2;
  }
  try {
    return run(words[1], words[2], std::atof(words[3]));
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 2;
  }
}
