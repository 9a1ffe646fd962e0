#pragma once
// Tells whether the files from which a run was made have changed since.

#include <string>
#include <utility>
#include <vector>

namespace armtune::internal::cli {

/// The files that a run was made from, as its run.yaml shows them, and their hashes.
using RunInputs = std::vector<std::pair<std::string, std::string>>;

/// Returns the inputs of a run folder; none if it has no run.yaml. Throws InputError if that cannot be read.
RunInputs inputs_of_run(const std::string& run);

/// Returns the first of these files that was an input of the run with other contents, or an empty text. A
/// relative path in run.yaml began at the folder where the run was started, which is not known: it means any
/// file whose path ends with it.
std::string changed_input(const RunInputs& inputs, const std::vector<std::string>& files);

}  // namespace armtune::internal::cli
