#include "tuner/cli/gain_set.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "armtune/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/session/task_notes.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal::cli {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

}  // namespace

std::string gains_name(const std::string& set) {
  return is_folder(set) ? run_file(set, "gains.yaml") : set;
}

std::vector<Scenario> scenarios_of(const std::string& set, const std::vector<std::string>& names,
                                   const std::vector<std::string>& otherwise) {
  if (names.empty() && is_folder(set)) {
    if (const auto study = find_run_file(set, "study.yaml")) return load_study(*study).scenarios;
  }
  std::vector<Scenario> scenarios;
  for (const std::string& name : names.empty() ? otherwise : names) {
    Scenario scenario = load_scenario(name);
    for (const Scenario& other : scenarios) {
      if (other.name == scenario.name)
        throw InputError(fmt::format("two scenarios have the name {}; rename one", other.name));
    }
    scenarios.push_back(std::move(scenario));
  }
  return scenarios;
}

GainSet load_gain_set(const std::string& set, const std::vector<Scenario>& scenarios) {
  const std::string path = find_data_file("gains", gains_name(set));
  for (const Scenario& scenario : scenarios) {
    refuse_winding(scenario, load_gains(path, joint_names(*scenario.robot)));
  }
  return {path, load_gains(path, joint_names(*scenarios.front().robot))};
}

GainsToSimulate gains_to_simulate(const std::string& name, const std::string& file) {
  std::string path = find_data_file("gains", file);
  return {name, path, [path](const Scenario& s) { return load_gains(path, joint_names(*s.robot)); }};
}

}  // namespace armtune::internal::cli
