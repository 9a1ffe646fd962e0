#pragma once
// Options that take one of a few names. They are the same in every command that has them.

#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace armtune::internal::cli {

/// Adds "--stepper", which selects how the dynamics of a control period are integrated.
CLI::Option* add_stepper_option(CLI::App& command, std::string& stepper);

/// Adds "--engine", which selects what computes the arm's accelerations.
CLI::Option* add_engine_option(CLI::App& command, std::string& engine);

/// Adds "--controller", which selects another controller than the one of the study's gains.
CLI::Option* add_controller_option(CLI::App& command, std::string& controller);

}  // namespace armtune::internal::cli
