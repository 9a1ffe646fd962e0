#include "tuner/interface/kept_inputs.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune {
namespace {

std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

InputFiles input_files(const std::vector<std::string>& paths) {
  InputFiles files;
  for (const std::string& path : paths) {
    if (!path.empty()) files.emplace_back(path, internal::hash_of_file(path));
  }
  return files;
}

std::vector<std::shared_ptr<const InputFiles>> files_of(const std::vector<Scenario>& scenarios) {
  std::vector<std::shared_ptr<const InputFiles>> files;
  files.reserve(scenarios.size());
  for (const Scenario& scenario : scenarios) files.push_back(scenario.files());
  return files;
}

std::vector<std::shared_ptr<const InputFiles>> files_of(const Study& study) {
  auto files = files_of(study.scenarios());
  files.push_back(study.files());
  return files;
}

KeptInputs::KeptInputs(const std::string& folder, const std::vector<std::shared_ptr<const InputFiles>>& files,
                       const std::string& what) {
  if (folder.empty()) return;
  for (const auto& some : files) {
    if (some == nullptr) {
      throw InputError(
          InputPlace{folder},
          fmt::format(
              "no file matches {}, so this folder cannot keep a copy of the input; run without a folder",
              what));
    }
  }
  alone_ = std::unique_lock(one_at_a_time());
  record_.emplace();
  for (const auto& some : files) {
    for (const auto& [path, hash] : *some) {
      internal::read_input_file(path, std::size_t{1} << 30U, "an input");
      if (internal::hash_of_input(path) != hash) {
        throw InputError(InputPlace{path}, "has changed since it was read; load the study or scenario again");
      }
    }
  }
}

}  // namespace armtune
