#pragma once
// The options of `armtune excite` that shape its motion, and the settings that follow from its options.

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
  std::vector<std::string> scenarios;  ///< whose arms write logs
  double fade = NAN;                   ///< [s]; NaN: depends on the duration
  ExciteSettings settings = {};
};

/// Adds the options that shape the motion.
void add_motion_options(CLI::App& command, ExciteArguments& args);

/// Returns the settings of a session. Throws InputError if a file cannot be used, or if the scenarios have
/// another robot.
ExciteSettings settings_of(const ExciteArguments& args);

}  // namespace armtune::internal::cli
