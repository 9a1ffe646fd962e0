#pragma once
// Completes the record of a run with its date, machine, versions and the hashes of its inputs, and writes it
// into the run folder.

#include <string>
#include <utility>
#include <vector>

#include "tuner/run/run_record.hpp"

namespace armtune::internal {

/// The files that a run read.
struct FilesRead {
  std::vector<std::string> inputs;  ///< paths, in any order, may contain duplicates
  /// Files such as logs and recordings, which are read as a stream and not kept in memory, each with its
  /// hash. They can be large, so no copies of them are kept.
  std::vector<std::pair<std::string, std::string>> streamed = {};
};

/// Sets the date, the versions, the machine, the arithmetic, and the inputs with the hashes of what was read.
/// The other members are those of `record`. No copies of the inputs are named.
RunRecord with_circumstances(RunRecord record, const FilesRead& files);

/// Writes run.json with these additions, and copies of the inputs into the folder inputs/ (keep_inputs). The
/// record names the copies. Throws InputError if a file cannot be written.
void write_run_record(const std::string& folder, RunRecord record, const FilesRead& files);

}  // namespace armtune::internal
