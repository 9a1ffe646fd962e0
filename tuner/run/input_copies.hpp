#pragma once
// inputs/ in a run's folder: a copy of every input as the run read it, so that a run can be resumed after one
// of them was edited or lost.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace armtune::internal {

/// Name of the folder in a run's folder where the copies are.
constexpr const char* kInputCopies = "inputs";

/// Writes a copy of every input that is kept in memory as it was read (see InputRecord), unless it is there
/// already from an earlier call; files of the run's folder itself need no copy. inputs: paths in any order,
/// twice or not. Returns for each copied input its name as run.yaml shows it, and the name of its copy below
/// the folder: "inputs/01_study.yaml". Throws InputError if a copy cannot be written.
std::vector<std::pair<std::string, std::string>> keep_inputs(const std::string& folder,
                                                             const std::vector<std::string>& inputs);

/// Returns the path of a copy whose contents have this hash, as `hashes` gives it, or nothing.
std::optional<std::string> copy_of_hash(const std::string& folder, const std::string& hash);

/// Returns " (the files as the run read them are in FOLDER/inputs)", or nothing where that is not there.
std::string where_copies_are(const std::string& folder);

}  // namespace armtune::internal
