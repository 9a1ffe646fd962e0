#pragma once
// Run folders of simulate, made of one recorded rollout.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <sstream>

#include "sim/rollout/error_report.hpp"
#include "tests/tuner/report/support/recorded.hpp"

namespace armtune::internal::test {

/// A run folder of simulate: the recorded rollout under each name, `repeats` times one after the other.
inline void write_run(const TemporaryFolder& folder, const std::vector<std::string>& names,
                      const std::vector<report::SceneSet>& sets, int repeats,
                      std::size_t most_rows = SIZE_MAX) {
  const CsvTable& table = recorded().table;
  std::string rollout;
  for (std::size_t c = 0; c < table.header().size(); ++c) rollout += (c > 0 ? "," : "") + table.header()[c];
  rollout += '\n';
  const double length = table.number(table.rows() - 1, 0) + 0.01;
  for (int k = 0; k < repeats; ++k) {
    for (std::size_t r = 0; r < std::min(table.rows(), most_rows); ++r) {
      std::ostringstream row;
      row.precision(9);
      for (std::size_t c = 0; c < table.header().size(); ++c) {
        row << (c > 0 ? "," : "") << table.number(r, c) + (c == 0 ? k * length : 0.0);
      }
      rollout += row.str() + '\n';
    }
  }
  std::vector<ScenarioResult> results;
  report::Scene scene = recorded().scene;
  const report::SceneScenario like = scene.scenarios.front();
  scene.scenarios.clear();
  scene.sets = sets;
  for (const std::string& name : names) {
    scene.scenarios.push_back(like);
    scene.scenarios.back().name = name;
    scene.scenarios.back().duration = repeats * length;
    results.push_back({name, {}});
  }
  for (const report::SceneSet& set : sets) {
    std::filesystem::create_directories(folder / set.folder);
    folder.write(set.errors, errors_csv(results));
    for (const std::string& name : names) folder.write(set.folder + "/rollout_" + name + ".csv", rollout);
  }
  folder.write("scene.json", report::scene_json(scene));
}

inline const std::vector<report::SceneSet> kTwoSets = {{"start", "start", "start/errors.csv"},
                                                       {"tuned", ".", "errors.csv"}};

}  // namespace armtune::internal::test
