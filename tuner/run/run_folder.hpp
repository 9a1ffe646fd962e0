#pragma once
// Makes the folder into which a run writes its results, and run.yaml in it. That file records how the results
// were made: versions, machine, seed, and hashes of the inputs.

#include <string>
#include <utility>
#include <vector>

#include "sim/rollout/error_report.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// Throws InputError if the folder exists and is not empty, because finished results are never overwritten.
void refuse_used_folder(const std::string& folder);

/// A lock on a run's folder. While it exists no other process can begin a run in the folder.
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

  /// Takes the lock. Returns false, with the reason in errno, if that fails: mostly another process has it.
  bool take();

 private:
  int descriptor_ = -1;
};

/// Makes the run's folder and locks it. Does nothing if its name is empty. Throws InputError if the folder is
/// not empty, if another run is about to write into it, or if it cannot be made.
[[nodiscard]] FolderLock make_run_folder(const std::string& folder);

/// Returns "runs/<name>_20261121-103000" (UTC), which is below the current folder.
std::string default_run_folder(const std::string& name);

/// Adds the columns of a file to a run's columns.csv, and replaces earlier ones of that file. Returns
/// ", FOLDER/columns.csv", to be added to the names of other files; empty if the folder has no columns.csv.
std::string add_columns(const std::string& folder, const FileColumns& columns);

/// The contents of run.yaml.
struct Provenance {
  std::string command;              ///< command that makes the run again, quoted for a shell
  std::vector<std::string> inputs;  ///< files, in any order, may contain duplicates
  /// Files that are read as a stream and not kept, such as logs, each with the hash of what was read.
  std::vector<std::pair<std::string, std::string>> streamed;
  unsigned long long seed = 0;
  int workers = 1;
  double wall_seconds = 0.0;
  std::vector<std::pair<std::string, std::string>> extra;  ///< further keys: values
  /// Names of inputs as run.yaml shows them, and the places of their copies in the run's folder.
  std::vector<std::pair<std::string, std::string>> copies;
};

/// Adds the files of every scenario to `inputs`.
void add_inputs(const std::vector<Scenario>& scenarios, std::vector<std::string>& inputs);

/// Returns name and hash of each input file, as run.yaml shows them. The hash is of what was read, if known.
std::vector<std::pair<std::string, std::string>> hashes(const std::vector<std::string>& inputs);

/// Returns the text of run.yaml: versions, machine, date, seed, hashes of every input file, copies.
std::string run_yaml(const Provenance& p);

/// Writes copies of all inputs as they were read into the folder's inputs/ (see InputRecord), and run.yaml,
/// which names them. Streamed inputs and recordings, which can be large, are hashed and not copied. Throws
/// InputError if a file cannot be written.
void write_provenance(const std::string& folder, Provenance p);

/// Returns name and version of every library in use, one per entry, as run.yaml and --version show them.
std::vector<std::pair<std::string, std::string>> versions();

/// Returns the circumstances under which a benchmark was measured, one per line: versions, processor, date.
std::string measured_with();

}  // namespace armtune::internal
