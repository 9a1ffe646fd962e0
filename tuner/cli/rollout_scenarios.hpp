#pragma once
// Finds the scenarios in which the rollouts of a run folder were simulated. `armtune yardstick` plans optimal
// motions for the same scenarios.

#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal::cli {

/// Returns the run folder that a folder with rollouts belongs to. This is the folder itself, or its parent if
/// the run keeps one of its gain sets in the folder.
std::string run_of(const std::string& folder);

/// Loads the scenarios called `names`. If `names` is empty, returns the scenario of every
/// rollout_<scenario>.csv in the folder. These come from the run's study, from the files that its run.yaml
/// names, or are bundled. Throws InputError if there is no rollout, if a scenario is not found, or if a file
/// has changed since the run was made. The message tells the user what to give instead.
std::vector<Scenario> rollout_scenarios(const std::string& folder, const std::vector<std::string>& names);

}  // namespace armtune::internal::cli
