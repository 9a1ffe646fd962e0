#include "tuner/planning/session/rollout_scenarios.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_record.hpp"
#include "tuner/session/changed_inputs.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kBegin = "rollout_";
constexpr std::string_view kEnd = ".csv";

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

/// Returns the names of the scenarios whose rollouts are in the folder, sorted.
std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string file = entry.path().filename().string();
    if (file.size() > kBegin.size() + kEnd.size() && file.starts_with(kBegin) && file.ends_with(kEnd))
      names.push_back(file.substr(kBegin.size(), file.size() - kBegin.size() - kEnd.size()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

[[noreturn]] void without_rollouts(const std::string& folder) {
  std::vector<std::string> below;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (!names_in(entry.path().string()).empty()) below.push_back(entry.path().string());
  }
  std::sort(below.begin(), below.end());
  throw InputError(InputPlace{folder},
                   fmt::format("has no rollout_*.csv; give {}",
                               below.empty() ? "a run folder of tune, or of simulate with --out"
                                             : fmt::format("one of its subfolders that have such files: {}",
                                                           fmt::join(below, ", "))));
}

/// Returns the scenarios of the run's study, or none if there is no study or its files cannot be loaded.
std::vector<Scenario> studied(const std::string& run) {
  const auto path = find_run_file(run, "study.yaml");
  if (!path) return {};
  try {
    return load_study(*path).scenarios;
  } catch (const InputError&) {
    return {};
  }
}

Scenario found_scenario(const std::string& name, const std::string& rollout, const RunInputs& inputs) {
  std::string told = "is not bundled, and the run's record names no file for it";
  for (const InputFact& input : inputs) {
    const std::string& shown = input.path;
    if (stem(shown) != name || input.bundled || !shown.ends_with(".yaml")) continue;
    if (exists(shown)) return load_scenario(shown);
    told = fmt::format("was read from {}, which no longer exists", shown);
  }
  const auto bundled = bundled_names("scenarios");
  if (std::find(bundled.begin(), bundled.end(), name) != bundled.end()) return load_scenario(name);
  throw InputError(InputPlace{rollout},
                   fmt::format("scenario '{}' {}; give its file: --scenarios FILE", name, told));
}

/// Throws InputError if a file of the scenario has changed since the run. A plan for the changed scenario
/// could not be compared with the rollout.
void refuse_changed(const Scenario& scenario, const std::string& run, const RunInputs& inputs) {
  const std::string changed = changed_input(inputs, scenario.inputs);
  if (changed.empty()) return;
  throw InputError(
      InputPlace{changed},
      fmt::format("this file has changed since the run {} simulated the scenario {}; simulate the "
                  "scenario again, or use the file as it is now with --scenarios {}",
                  run, scenario.name, scenario.name));
}

}  // namespace

std::string run_folder_of(const std::string& folder) {
  const std::string above = without_dots(folder + "/..");
  const bool own = exists(folder + "/" + kRunRecord);
  return !own && exists(above + "/" + kRunRecord) ? above : folder;
}

std::vector<Scenario> rollout_scenarios(const std::string& folder, const std::vector<std::string>& names) {
  std::vector<Scenario> scenarios;
  if (!names.empty()) {
    scenarios.reserve(names.size());
    for (const std::string& name : names) scenarios.push_back(load_scenario(name));
    return scenarios;
  }
  const auto recorded = names_in(folder);
  if (recorded.empty()) without_rollouts(folder);
  const std::string run = run_folder_of(folder);
  const RunInputs inputs = inputs_of_run(run);
  const std::vector<Scenario> study = studied(run);
  scenarios.reserve(recorded.size());
  for (const std::string& name : recorded) {
    const auto found =
        std::find_if(study.begin(), study.end(), [&name](const Scenario& s) { return s.name == name; });
    scenarios.push_back(found != study.end()
                            ? *found
                            : found_scenario(name, fmt::format("{}/rollout_{}.csv", folder, name), inputs));
    refuse_changed(scenarios.back(), run, inputs);
  }
  return scenarios;
}

}  // namespace armtune::internal
