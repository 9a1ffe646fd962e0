#pragma once
// Checks that the files of a study or scenario have not changed since they were read, and keeps their
// contents in memory. A run then stores copies of them in its folder, which show what was simulated.

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "armtune/study.hpp"
#include "core/common/input_file.hpp"

namespace armtune {

/// Returns the path and the present hash of each file. Empty paths are left out.
InputFiles input_files(const std::vector<std::string>& paths);

/// Returns the files that a study and its scenarios, or only scenarios, were read from. An entry is null if
/// no file matches that study or scenario, because it was changed or not read from files.
std::vector<std::shared_ptr<const InputFiles>> files_of(const Study& study);
std::vector<std::shared_ptr<const InputFiles>> files_of(const std::vector<Scenario>& scenarios);

/// A guard that lives as long as a run in `folder`. It makes sure that every input file of the run still has
/// the bytes it was read with, and that the run can store copies of them. Without a folder it does nothing.
/// Only one exists at a time: the constructor of a second one waits until the first is destroyed.
class KeptInputs {
 public:
  /// Throws InputError naming a file that has changed since it was read. Also throws if an entry of `files`
  /// is null, because no file then matches the study or scenario. what: words for this study or scenario in
  /// the message.
  KeptInputs(const std::string& folder, const std::vector<std::shared_ptr<const InputFiles>>& files,
             const std::string& what);

 private:
  std::unique_lock<std::mutex> alone_;
  std::optional<internal::InputRecord> record_;
};

}  // namespace armtune
