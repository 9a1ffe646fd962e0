#pragma once
// Copies of a run's input files, in the folder inputs/ of the run folder. They have the contents that the run
// has read. With them a run can be resumed after an input file was edited or lost.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace armtune::internal {

/// Name of the folder with the copies in a run's folder.
constexpr const char* kInputCopies = "inputs";

/// Writes a copy of every input whose contents are kept in memory (see InputRecord), unless an earlier call
/// wrote it already. Files in the run folder itself are not copied. inputs: paths in any order, may contain
/// duplicates. Returns two names for each input with a copy: the input's name as run.json shows it, and the
/// copy's name below the run folder, such as "inputs/01_study.yaml". Throws InputError if a copy cannot be
/// written.
std::vector<std::pair<std::string, std::string>> keep_inputs(const std::string& folder,
                                                             const std::vector<std::string>& inputs);

/// Returns the path of a copy whose contents have this hash, or nothing. hash: in the form that `hashes`
/// (run_folder.hpp) returns.
std::optional<std::string> copy_of_hash(const std::string& folder, const std::string& hash);

/// Returns " (copies of the files that the run read are in FOLDER/inputs)", or an empty text without copies.
std::string where_copies_are(const std::string& folder);

}  // namespace armtune::internal
