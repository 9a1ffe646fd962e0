#pragma once
// The command line options of `armtune excite`, which designs a motion for identifying an arm's dynamics.
// Adds the options that shape the motion, and converts all options to the settings of a session.

#include <cmath>
#include <string>
#include <vector>

#include "tuner/cli/excite_printer.hpp"

namespace CLI {
class App;
}

namespace armtune::internal::cli {

struct ExciteArguments {
  std::string robot;                   ///< bundled robot, robot YAML or URDF
  std::vector<double> center_deg;      ///< one per joint [deg, m]; empty: the middle of the position limits
  std::vector<std::string> scenarios;  ///< scenarios whose arms are simulated
  double fade = NAN;                   ///< [s]; NaN: depends on the duration
  ExciteSettings settings = {};
};

/// Adds the options that shape the motion.
void add_motion_options(CLI::App& command, ExciteArguments& args);

/// Converts the options to the settings of a session. Throws InputError if a file cannot be used, or if a
/// scenario has another robot than args.robot.
ExciteSettings settings_of(const ExciteArguments& args);

}  // namespace armtune::internal::cli
