#pragma once
// Keeps the files that a study or scenario was read from, so that a run folder shows what was simulated.

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "armtune/study.hpp"
#include "core/common/input_file.hpp"

namespace armtune {

/// Returns path and hash of each file as it is now.
InputFiles input_files(const std::vector<std::string>& paths);

/// Return the files of the study and of its scenarios.
std::vector<std::shared_ptr<const InputFiles>> files_of(const Study& study);
std::vector<std::shared_ptr<const InputFiles>> files_of(const std::vector<Scenario>& scenarios);

/// A guard that makes sure that every input of the run in `folder` still has the bytes it was read with, and
/// that the run keeps copies of them. Without a folder it does nothing. Only one exists at a time: a second
/// one waits for the first.
class KeptInputs {
 public:
  /// Throws InputError naming a file that has changed since it was read. Also throws if an entry of `files`
  /// is null, because then no files contain `what`.
  KeptInputs(const std::string& folder, const std::vector<std::shared_ptr<const InputFiles>>& files,
             const std::string& what);

 private:
  std::unique_lock<std::mutex> alone_;
  std::optional<internal::InputRecord> record_;
};

}  // namespace armtune
