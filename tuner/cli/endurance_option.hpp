#pragma once
// The option "--endurance [MINUTES]" of `armtune simulate` and `armtune compare`, and its printed results.
// The option extends every scenario to that many simulated minutes, to find faults that appear only after a
// long time.

#include <string>
#include <vector>

#include "tuner/endurance/endurance.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace armtune::internal::cli {

/// Declares the option and returns it. minutes: 0 if the option is not given, 30 if it has no value.
CLI::Option* add_endurance_option(CLI::App& command, double& minutes);

/// Prints for each scenario how its task continues when the scenario is extended.
void say_how_extended(const std::vector<Scenario>& scenarios);

/// Returns one line per scenario: how long the arm stayed within all limits, or which one it exceeded first.
std::string endurance_table(const std::vector<EnduranceResult>& results);

}  // namespace armtune::internal::cli
