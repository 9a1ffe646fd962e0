#pragma once
// "--endurance [MINUTES]": what simulate and compare do with it.

#include <functional>
#include <string>
#include <vector>

#include "tuner/endurance/endurance.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace armtune::cli {

/// Declares the option and returns it. minutes: 0 unless it is given, 30 without a value.
CLI::Option* add_endurance_option(CLI::App& command, double& minutes);

/// Simulates the extended scenarios with a progress line, and prints how what they ask for is extended.
/// set: name of the gain set for the progress line.
std::vector<EnduranceResult> run_endurance(const std::vector<Scenario>& scenarios,
                                           const std::function<Gains(const Scenario&)>& gains_of,
                                           const EnduranceOptions& options, const std::string& set);

/// One line per scenario: how long it held, or what broke first.
std::string endurance_table(const std::vector<EnduranceResult>& results);

}  // namespace armtune::cli
