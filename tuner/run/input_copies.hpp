#pragma once
// Copies of a run's inputs, in inputs/ of its folder, as the run read them. With them a run can be resumed
// after an input was edited or lost.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace armtune::internal {

/// Name of the folder with the copies in a run's folder.
constexpr const char* kInputCopies = "inputs";

/// Writes a copy of every input that is kept in memory as it was read (see InputRecord), unless an earlier
/// call wrote it already. Files in the run's folder itself are not copied. inputs: paths in any order, may
/// contain duplicates. Returns for each copied input its name as run.yaml shows it, and the name of its copy
/// below the folder: "inputs/01_study.yaml". Throws InputError if a copy cannot be written.
std::vector<std::pair<std::string, std::string>> keep_inputs(const std::string& folder,
                                                             const std::vector<std::string>& inputs);

/// Returns the path of a copy whose contents have this hash, as `hashes` gives it, or nothing.
std::optional<std::string> copy_of_hash(const std::string& folder, const std::string& hash);

/// Returns " (copies of the files that the run read are in FOLDER/inputs)", or an empty text without copies.
std::string where_copies_are(const std::string& folder);

}  // namespace armtune::internal
