#pragma once
// Makes the folder into which a run writes its results. Also determines the circumstances of a run: the
// versions in use, the machine, the time, and the hashes of the inputs.

#include <string>
#include <utility>
#include <vector>

#include "sim/rollout/error_report.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/run/run_facts.hpp"

namespace armtune::internal {

/// Throws InputError if the folder exists and is not empty, because finished results are never overwritten.
void refuse_used_folder(const std::string& folder);

/// A lock on a run folder. While this object exists, no other process can begin a run in the folder.
class FolderLock {
 public:
  FolderLock() = default;  ///< locks no folder
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}
  FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FolderLock& operator=(FolderLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~FolderLock();

  /// Takes the lock. If that fails, returns false with the reason in errno; usually another process has the
  /// lock.
  bool take();

 private:
  int descriptor_ = -1;
};

/// Makes the run folder and locks it. Does nothing if its name is empty. Throws InputError if the folder is
/// not empty, if another run has locked it, or if it cannot be made.
[[nodiscard]] FolderLock make_run_folder(const std::string& folder);

/// Returns a path with the present time in UTC, such as "runs/<name>_20261121-103000". It is relative to the
/// working directory.
std::string default_run_folder(const std::string& name);

/// Writes the descriptions of a file's columns into columns.csv of the run folder, and replaces earlier
/// descriptions of that file. Returns the path of columns.csv. If the folder has no columns.csv, nothing is
/// written, and the returned text is empty.
std::string add_columns(const std::string& folder, const FileColumns& columns);

/// Adds the files of every scenario to `inputs`.
void add_inputs(const std::vector<Scenario>& scenarios, std::vector<std::string>& inputs);

/// Returns name and hash of each input file, sorted, as run.json shows them. The hash is the result of
/// hash_of_input().
std::vector<std::pair<std::string, std::string>> hashes(const std::vector<std::string>& inputs);

/// Returns the present time in UTC, such as "2026-11-26T05:27:03Z".
std::string utc_time();

/// Returns the machine on which this process runs.
MachineFacts this_machine();

/// Returns name and version of every library in use, one per entry, as run.json and --version show them.
std::vector<std::pair<std::string, std::string>> versions();

/// Returns the circumstances under which a benchmark was measured, one per line: versions, processor, date.
std::string measured_with();

}  // namespace armtune::internal
