#include "tuner/session/changed_inputs.hpp"

#include <filesystem>
#include <utility>

#include "core/common/file_path.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace {

/// Returns true if `text`, an input in run.json, may mean the file at this absolute path.
bool may_mean(const std::string& text, const std::string& path) {
  if (text.starts_with('/')) return text == path;
  std::string shown = std::filesystem::path(text).lexically_normal().string();
  while (shown.starts_with("../")) shown.erase(0, 3);
  return path.ends_with("/" + shown);
}

}  // namespace

RunInputs inputs_of_run(const std::string& run) {
  auto record = find_run_record(run);
  return record ? std::move(record->inputs) : RunInputs();
}

std::string changed_input(const RunInputs& inputs, const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    std::string shown = shown_path(file);
    const std::string path = absolute_path(file);
    bool changed = false, same = false;
    for (const InputFact& then : inputs) {
      if (then.path != shown && !may_mean(then.path, path)) continue;
      (then.hash == hash_of_input(file) ? same : changed) = true;
    }
    if (changed && !same) return shown;
  }
  return {};
}

}  // namespace armtune::internal
