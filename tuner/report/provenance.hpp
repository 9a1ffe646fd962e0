#pragma once
// Reads run.yaml of a run folder, which records how the results were made: the command, versions, and hashes
// of the input files. The report shows them.

#include <string>
#include <utility>
#include <vector>

namespace armtune::internal::report {

/// Returns every value as text, in the order of the file, with its key as a path such as "versions/eigen".
/// Throws InputError if the file cannot be read.
std::vector<std::pair<std::string, std::string>> read_provenance(const std::string& path);

}  // namespace armtune::internal::report
