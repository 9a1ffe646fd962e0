#pragma once
// RUN_OR_GAINS on the command line: a run folder stands for the gains in it and for its study's scenarios.

#include <string>
#include <vector>

#include "tuner/session/simulate_session.hpp"

namespace armtune::internal::cli {

/// The gains file of a run folder; any other name as it is.
std::string gains_name(const std::string& set);

/// Those named; else those of the run folder's study; else `otherwise`. Throws InputError if two share a
/// name.
std::vector<Scenario> scenarios_of(const std::string& set, const std::vector<std::string>& names,
                                   const std::vector<std::string>& otherwise);

struct GainSet {
  std::string path;  ///< of the file
  Gains gains;
};

/// The gains of a set. Throws InputError unless they fit the robot of every scenario (at least one), and
/// where a path winds a joint up.
GainSet load_gain_set(const std::string& set, const std::vector<Scenario>& scenarios);

/// The gains of a file, to be read for each scenario's robot. name: of the set, for tables. Throws InputError
/// if there is no such file.
GainsToSimulate gains_to_simulate(const std::string& name, const std::string& file);

}  // namespace armtune::internal::cli
