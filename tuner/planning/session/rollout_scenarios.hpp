#pragma once
// Finds the scenarios in which the rollouts of a run folder were simulated. `armtune yardstick` plans optimal
// motions for the same scenarios.

#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Returns the run folder that a folder with rollouts belongs to. A run may keep the rollouts of each gain
/// set in a subfolder. Therefore the result is the parent of the folder if only the parent has a run.json,
/// otherwise the folder itself.
std::string run_folder_of(const std::string& folder);

/// Loads the scenarios called `names`. If `names` is empty, returns the scenario of every
/// rollout_<scenario>.csv in the folder. A scenario is searched first in the run's study, then among the
/// files that the run's run.json names, then among the bundled scenarios. Throws InputError if there is no
/// rollout, if a scenario is not found, or if a file of a scenario has changed since the run was made. The
/// message tells the user what to give instead.
std::vector<Scenario> rollout_scenarios(const std::string& folder, const std::vector<std::string>& names);

}  // namespace armtune::internal
