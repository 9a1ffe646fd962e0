#include "tuner/session/changed_inputs.hpp"

#include <filesystem>
#include <string_view>

#include "core/common/file_path.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/report/provenance.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::internal {
namespace {

constexpr std::string_view kInputPrefix = "inputs/";  // prefix of run.yaml's keys for input files

/// Returns true if `text`, an input in run.yaml, may mean the file at this absolute path.
bool may_mean(const std::string& text, const std::string& path) {
  if (text.starts_with('/')) return text == path;
  std::string shown = std::filesystem::path(text).lexically_normal().string();
  while (shown.starts_with("../")) shown.erase(0, 3);
  return path.ends_with("/" + shown);
}

}  // namespace

RunInputs inputs_of_run(const std::string& run) {
  RunInputs inputs;
  const auto path = find_run_file(run, "run.yaml");
  if (!path) return inputs;
  for (const auto& [key, value] : report::read_provenance(*path)) {
    if (key.starts_with(kInputPrefix)) inputs.emplace_back(key.substr(kInputPrefix.size()), value);
  }
  return inputs;
}

std::string changed_input(const RunInputs& inputs, const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    std::string shown = shown_path(file);
    const std::string path = absolute_path(file);
    bool changed = false, same = false;
    for (const auto& [then, hash] : inputs) {
      if (then != shown && !may_mean(then, path)) continue;
      (hash == hash_of_input(file) ? same : changed) = true;
    }
    if (changed && !same) return shown;
  }
  return {};
}

}  // namespace armtune::internal
