#pragma once
// The files that a study or scenario was read from, so that a run folder tells of what was simulated.

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "armtune/study.hpp"
#include "core/common/input_file.hpp"

namespace armtune {

/// Path and hash of each file as it is now.
InputFiles input_files(const std::vector<std::string>& paths);

/// Those of the study and of its scenarios.
std::vector<std::shared_ptr<const InputFiles>> files_of(const Study& study);
std::vector<std::shared_ptr<const InputFiles>> files_of(const std::vector<Scenario>& scenarios);

/// While it lives, every input of the run in `folder` has the bytes that it was read with, and the run keeps
/// copies of them. Where there is no folder it does nothing. One lives at a time: a second one waits.
class KeptInputs {
 public:
  /// Throws InputError naming a file that has changed since, or saying that no files hold `what`: where
  /// `files` is null.
  KeptInputs(const std::string& folder, const std::vector<std::shared_ptr<const InputFiles>>& files,
             const std::string& what);

 private:
  std::unique_lock<std::mutex> alone_;
  std::optional<internal::InputRecord> record_;
};

}  // namespace armtune
