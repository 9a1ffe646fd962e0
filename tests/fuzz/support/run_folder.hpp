#pragma once
// A run folder of which one file has been fuzzed, and the page that is made of it.

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "tests/fuzz/support/input.hpp"
#include "tuner/report/run_report.hpp"

namespace armtune::internal::fuzz {

/// A copy of tests/fuzz/run, small and of a real run, that lives as long as the object; in memory where the
/// system has a place for that.
class RunFolder {
 public:
  RunFolder() {
    namespace fs = std::filesystem;
    const fs::path memory = "/dev/shm";
    std::error_code ignored;
    path_ = (fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path()) /
            ("armtune_fuzz_" + std::to_string(::getpid()));
    fs::remove_all(path_, ignored);
    fs::copy(ARMTUNE_FUZZ_RUN, path_, fs::copy_options::recursive);
  }
  ~RunFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  std::string path() const { return path_.string(); }
  void write(const std::string& name, std::string_view bytes) const {
    std::ofstream file(path_ / name, std::ios::binary | std::ios::trunc);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    require(file.good());
  }
  void remove(const std::string& name) const { std::filesystem::remove(path_ / name); }

 private:
  std::filesystem::path path_;
};

inline void check_run(const report::Run& run, std::size_t sets) {
  require(run.set < sets);
  for (const report::PlotColumn& column : run.columns)
    require(column.series.steps.size() == run.time.steps.size());
  const report::Replay& replay = run.replay;
  require(replay.n == 0 || (std::isfinite(replay.dt) && replay.dt > 0.0));
  for (const auto* all : {&replay.q, &replay.target, &replay.tool, &replay.velocity_ratio}) {
    for (const report::Series& series : *all) require(series.steps.size() == replay.n);
  }
}

/// Makes the page's data of the folder, whatever is in it, and requires what the page takes for granted:
/// every index leads to something, series are as long as their times, and no text can end the element it
/// stands in.
inline void check_report(const RunFolder& folder) {
  read_or_refuse([&] {
    const report::ReportData data = report::report_of(folder.path());
    for (const report::ReportScenario& scenario : data.scenarios) {
      require(scenario.arm >= -1 && scenario.arm < static_cast<long>(data.arms.size()));
      for (const report::Run& run : scenario.runs) {
        check_run(run, data.sets.size());
        require(run.replay.obstacles.empty() || run.replay.obstacles.size() == scenario.obstacles.size());
      }
    }
    for (const report::Table& table : data.tables) {
      require(table.status.size() == data.sets.size());
      for (const report::MetricRow& row : table.rows) require(row.values.size() == data.sets.size());
    }
    if (data.evaluations) {
      const report::Evaluations& e = *data.evaluations;
      const std::size_t n = e.objective.size();
      require(e.of.size() == n && e.feasible.size() == n && e.violation.size() == n);
      require(e.start < static_cast<long>(n) && e.chosen < static_cast<long>(n));
      for (const std::size_t phase : e.of) require(phase < e.phases.size());
    }
    const std::string json = report::report_json(data);
    require(json.find('<') == std::string::npos && json.size() <= 5'000'000);
  });
}

}  // namespace armtune::internal::fuzz
