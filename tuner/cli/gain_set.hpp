#pragma once
// Reads the command line argument RUN_OR_GAINS. The argument names bundled gains, a gains file, or the folder
// of an earlier run. A folder stands for the gains in it and for the scenarios of its study.

#include <string>
#include <vector>

#include "tuner/session/simulate_session.hpp"

namespace armtune::internal::cli {

/// Returns the path of the gains file of a run folder. Any other name is returned unchanged.
std::string gains_name(const std::string& set);

/// Returns the scenarios called `names`. If `names` is empty and `set` is a run folder with a study, returns
/// the scenarios of this study. In all other cases, returns the scenarios called `otherwise`. Throws
/// InputError if two of the scenarios have the same name.
std::vector<Scenario> scenarios_of(const std::string& set, const std::vector<std::string>& names,
                                   const std::vector<std::string>& otherwise);

struct GainSet {
  std::string path;  ///< of the gains file
  Gains gains;
};

/// Reads the gains of a set, for the robot of the first scenario. scenarios: at least one. Throws InputError
/// if the gains are not valid for the robot of every scenario. Also throws if the tool's path makes a joint
/// drift beyond its position limits, whatever the gains are.
GainSet load_gain_set(const std::string& set, const std::vector<Scenario>& scenarios);

/// Returns the gain set in a file. The file is read for each scenario, with the joints of its robot. name:
/// name of the set in tables. Throws InputError if there is no such file.
GainsToSimulate gains_to_simulate(const std::string& name, const std::string& file);

}  // namespace armtune::internal::cli
