#pragma once
// Adds command line options whose value is one of a few names, such as --engine. Several commands share them.

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

/// Adds "--controller", which selects a controller to tune in place of the study's own.
CLI::Option* add_controller_option(CLI::App& command, std::string& controller);

/// Adds "--controller", which selects a controller that follows joint motions, for a study without a
/// parameter file.
CLI::Option* add_joint_motion_controller_option(CLI::App& command, std::string& controller);

}  // namespace armtune::internal::cli
