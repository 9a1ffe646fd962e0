#pragma once
// "--endurance [MINUTES]": what simulate and compare do with it.

#include <string>
#include <vector>

#include "tuner/endurance/endurance.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace armtune::internal::cli {

/// Declares the option and returns it. minutes: 0 unless it is given, 30 without a value.
CLI::Option* add_endurance_option(CLI::App& command, double& minutes);

/// Prints how what the scenarios ask for is extended.
void say_how_extended(const std::vector<Scenario>& scenarios);

/// One line per scenario: how long it held, or what broke first.
std::string endurance_table(const std::vector<EnduranceResult>& results);

}  // namespace armtune::internal::cli
