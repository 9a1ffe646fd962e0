#pragma once
// The folder a run leaves behind, and where its results came from.

#include <string>
#include <utility>
#include <vector>

#include "sim/rollout/error_report.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Throws InputError if the folder exists and holds anything: finished results are never overwritten.
void refuse_used_folder(const std::string& folder);

/// While it lives no other process can begin a run in the folder.
class FolderLock {
 public:
  FolderLock() = default;  ///< of no folder
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}
  FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FolderLock& operator=(FolderLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~FolderLock();

  /// False, with the reason in errno, if another process has it.
  bool take();

 private:
  int descriptor_ = -1;
};

/// Makes the run's folder; nothing where its name is empty. Throws InputError if it holds anything, if
/// another run is about to write into it, or if it cannot be made.
[[nodiscard]] FolderLock make_run_folder(const std::string& folder);

/// "runs/<name>_20261121-103000" (UTC) below the current folder.
std::string default_run_folder(const std::string& name);

/// Adds the columns of a file to a run's columns.csv, in place of what it said of that file before. Returns
/// ", FOLDER/columns.csv" to follow the names of other files; empty where the folder has none.
std::string add_columns(const std::string& folder, const FileColumns& columns);

/// What run.yaml says.
struct Provenance {
  std::string command;              ///< that makes the run again, quoted for a shell
  std::vector<std::string> inputs;  ///< files, in any order, twice or not
  /// Files that are read as a stream and not kept, such as logs, and the hash of what was read of each.
  std::vector<std::pair<std::string, std::string>> streamed;
  unsigned long long seed = 0;
  int workers = 1;
  double wall_seconds = 0.0;
  std::vector<std::pair<std::string, std::string>> extra;  ///< further keys: values
  /// Names of inputs, as run.yaml shows them, and where in the run's folder their copies are.
  std::vector<std::pair<std::string, std::string>> copies;
};

/// Adds the files of every scenario to `inputs`.
void add_inputs(const std::vector<Scenario>& scenarios, std::vector<std::string>& inputs);

/// Name and hash of each input file, as run.yaml shows them: of what was read, where that is known.
std::vector<std::pair<std::string, std::string>> hashes(const std::vector<std::string>& inputs);

/// Text of run.yaml: versions, machine, date, seed, hashes of every input file, copies.
std::string run_yaml(const Provenance& p);

/// Writes into the folder's inputs/ a copy of every input as it was read (see InputRecord), and run.yaml,
/// which names them. Streamed inputs and recordings, which can be large, are hashed and not copied. Throws
/// InputError.
void write_provenance(const std::string& folder, Provenance p);

/// Name and version of every library in use, one per line, as run.yaml and --version show them.
std::vector<std::pair<std::string, std::string>> versions();

/// Where and when a figure was measured, one per line: versions, processor, date.
std::string measured_with();

}  // namespace armtune::internal
