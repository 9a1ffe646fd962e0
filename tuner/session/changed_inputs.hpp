#pragma once
// Finds input files of a run that have changed since the run was made. `armtune sensitivity` and `armtune
// yardstick` refuse to work with such a run.

#include <string>
#include <vector>

#include "tuner/run/run_facts.hpp"

namespace armtune::internal {

/// The input files of a run.
using RunInputs = std::vector<InputFact>;

/// Returns the inputs of the run in a folder, or none if the folder has no run.json. Throws InputError if
/// run.json cannot be read.
RunInputs inputs_of_run(const std::string& run);

/// Returns the first of `files` that was an input of the run but has other contents now, or an empty text if
/// there is none. A relative path in run.json starts at the folder in which the run was started. That folder
/// is not known here, so the path matches every file whose path ends with it.
std::string changed_input(const RunInputs& inputs, const std::vector<std::string>& files);

}  // namespace armtune::internal
