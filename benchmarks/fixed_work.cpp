// A fixed piece of work for an instruction counter: one rollout of the published gains, nothing else.
// Twice with different durations, the difference is what the control periods between them cost.

#include <fmt/format.h>

#include <cstdlib>
#include <exception>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"

namespace {

using namespace armtune;

int run(const char* engine, const char* name, double seconds) {
  Scenario scenario = load_scenario(name);
  scenario.duration = seconds;
  const Gains gains = load_gains("published", joint_names(*scenario.robot));
  Rollout rollout(scenario, Stepper::kMidpoint, engine_from_name(engine));
  const RolloutResult result = rollout.run(gains);
  fmt::print("{} periods, {}\n", scenario.periods(), armtune::name(result.status));
  return result.end_time == seconds ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    fmt::print(stderr, "Usage: benchmark_work simbody|native SCENARIO SECONDS\n");
    return 2;
  }
  try {
    return run(words[1], words[2], std::atof(words[3]));
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 2;
  }
}
