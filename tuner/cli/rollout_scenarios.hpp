#pragma once
// The scenarios of the rollouts that lie in a folder.

#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal::cli {

/// The folder of the run that a folder with rollouts belongs to: itself, or the one above where a run keeps
/// one of its gain sets in it.
std::string run_of(const std::string& folder);

/// Those of `names`; unless given, of every rollout_<scenario>.csv in the folder: from the run's study, from
/// the files that its run.yaml names, or bundled. Throws InputError that says what to give where there is no
/// rollout, where a scenario is not found, and where a file is no longer what it was when the run was made.
std::vector<Scenario> rollout_scenarios(const std::string& folder, const std::vector<std::string>& names);

}  // namespace armtune::internal::cli
