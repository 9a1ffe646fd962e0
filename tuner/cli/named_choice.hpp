#pragma once
// Options that take one of a few names, the same in every command that has them.

#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace armtune::internal::cli {

/// "--stepper": how a period is stepped.
CLI::Option* add_stepper_option(CLI::App& command, std::string& stepper);

/// "--engine": what computes the arm's accelerations.
CLI::Option* add_engine_option(CLI::App& command, std::string& engine);

/// "--controller": another controller than the study's gains are for.
CLI::Option* add_controller_option(CLI::App& command, std::string& controller);

}  // namespace armtune::internal::cli
