#include "tuner/report/run_recordings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"
#include "tuner/record/json_writer.hpp"
#include "tuner/report/nearest_obstacles.hpp"
#include "tuner/report/recording.hpp"
#include "tuner/report/telling.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::internal::report {
namespace {

constexpr std::size_t kColumnsBesideJoints = 25;
constexpr std::size_t kSeriesBesideJoints = 13;     // target, tool, error and closest points of a replay
constexpr std::size_t kForObstaclesAtLeast = 8000;  // [bytes] about eight of them

class Recordings {
 public:
  Recordings(const std::string& folder, const Scene& scene, std::size_t room, ReportData& data)
      : folder_(folder), scene_(scene), room_(room), data_(data) {}

  void add() {
    std::vector<std::size_t> order = telling_order(names(), data_.tables, last_set());
    std::erase_if(order, [this](std::size_t s) { return find_files(s) == 0; });
    keep_what_fits(order);
    // The scenarios keep the order of the run, so that a reader finds them.
    std::sort(order.begin(), order.end());
    std::size_t runs = 0;
    for (const std::size_t s : order) runs += files_[s].size();
    std::size_t scenarios = order.size();
    for (const std::size_t s : order) {
      // A part of the room stays free, because sizes are estimates.
      const std::size_t room = room_ - std::min(room_, room_ / 20 + scenarios * kLeastOfScenario);
      add_scenario(s, room / std::max<std::size_t>(1, runs));
      runs -= files_[s].size();
      --scenarios;
    }
    tell_of_replays();
  }

 private:
  struct File {
    std::size_t set;
    std::string path;
  };

  std::size_t last_set() const { return scene_.sets.empty() ? 0 : scene_.sets.size() - 1; }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    names.reserve(data_.scenarios.size());
    for (const ReportScenario& s : data_.scenarios) names.push_back(s.name);
    return names;
  }

  const SceneScenario* scene_of(const std::string& name) const {
    const auto found = std::find_if(scene_.scenarios.begin(), scene_.scenarios.end(),
                                    [&name](const SceneScenario& s) { return s.name == name; });
    return found == scene_.scenarios.end() ? nullptr : &*found;
  }

  /// Returns an entry of a scenario's table; empty if there is none.
  std::string of_set(const std::string& scenario, std::size_t set,
                     std::vector<std::string> Table::*entries) const {
    for (const Table& table : data_.tables) {
      if (table.scenario == scenario && set < (table.*entries).size()) return (table.*entries)[set];
    }
    return {};
  }

  /// Finds the recordings of a scenario, and returns their number.
  std::size_t find_files(std::size_t s) {
    files_.resize(data_.scenarios.size());
    const std::string& name = data_.scenarios[s].name;
    for (std::size_t set = 0; set < scene_.sets.size(); ++set) {
      const std::string file = name_in(scene_.sets[set], "rollout_" + name + ".csv");
      try {
        if (auto path = find_run_file(folder_, file)) {
          files_[s].push_back({set, *std::move(path)});
        } else if (of_set(name, set, &Table::status) == "completed") {  // rollouts that ended early have none
          data_.left_out.push_back(
              fmt::format("{}/{}: its plots and its replay, because the file is missing", folder_, file));
        }
      } catch (const InputError& error) {
        data_.left_out.emplace_back(error.what());
      }
    }
    return files_[s].size();
  }

  std::size_t joints_of_scenario(const SceneScenario* s) const {
    return s == nullptr ? 0 : scene_.arms[s->arm].joints.size();
  }

  /// Returns the bytes of one run of the scenario at the coarsest resolution.
  std::size_t least_of(std::size_t s) const {
    const SceneScenario* scenario = scene_of(data_.scenarios[s].name);
    const std::size_t joints = joints_of_scenario(scenario);
    const std::size_t obstacles =
        scenario != nullptr && !scenario->obstacles.empty() ? kForObstaclesAtLeast : 0;
    return least_bytes(kColumnsBesideJoints + 2 * joints, kSeriesBesideJoints + 2 * joints) + obstacles;
  }

  void keep_what_fits(std::vector<std::size_t>& order) {
    std::size_t used = 0;
    std::size_t kept = 0;
    for (; kept < order.size(); ++kept) {
      used += files_[order[kept]].size() * least_of(order[kept]) + kLeastOfScenario;
      if (used + room_ / 20 > room_) break;
    }
    if (kept == order.size()) return;
    data_.thinned.push_back(fmt::format(
        "plots and replays of {} of {} scenarios; those that failed or broke a limit are shown first",
        order.size() - kept, order.size()));
    order.resize(kept);
  }

  Run run_at(const File& file, const std::string& name, const NumberTable& recording,
             const SceneScenario* scenario, std::size_t share) {
    const Arm* arm = scenario != nullptr ? &scene_.arms[scenario->arm] : nullptr;
    const std::size_t joints = joints_of_scenario(scenario);
    const auto& times = recording.numbers(recording.column("time"));
    const double seconds = times.empty() ? 0.0 : times.back() - times.front();
    const std::size_t series =
        kSeriesBesideJoints + 2 * joints +
        3 * (scenario != nullptr ? scenario->obstacles.size() + scenario->cell.size() : 0);
    Run run = run_of(recording, scenario, arm,
                     resolution_for(share, kColumnsBesideJoints + 2 * joints, series, seconds));
    run.set = file.set;
    run.status = of_set(name, file.set, &Table::status);
    run.reason = of_set(name, file.set, &Table::reason);
    // The end may lie between two rows, but not farther away.
    const double row_after =
        run.end * (1.0 + 1.5 / static_cast<double>(std::max<std::size_t>(2, recording.rows()) - 1));
    if (scenario != nullptr && run.status == "completed" && row_after < scenario->duration) {
      data_.left_out.push_back(
          fmt::format("{}: everything after {:.3f} s of {:.6g} s, because the file ends there", file.path,
                      run.end, scenario->duration));
    }
    if (run.reason.empty() && !run.status.empty() && run.status != "completed")
      run.reason = fmt::format("{} at {:.3f} s", run.status, run.end);
    return run;
  }

  /// Adds plots and replays of a scenario. share: bytes for each of its runs.
  void add_scenario(std::size_t s, std::size_t share) {
    ReportScenario& shown = data_.scenarios[s];
    const SceneScenario* whole = scene_of(shown.name);
    std::optional<SceneScenario> scenario;
    ReportScenario with_runs = shown;
    for (const File& file : files_[s]) {
      try {
        const NumberTable recording = read_recording(file.path);
        if (whole != nullptr && !scenario) {
          scenario = *whole;
          keep_nearest(recording, most_obstacles(share, recording.rows()), *scenario);
        }
        Run run = run_at(file, shown.name, recording, scenario ? &*scenario : nullptr, share);
        if (whole == nullptr) with_runs.duration = std::max(with_runs.duration, run.end);
        with_runs.runs.push_back(std::move(run));
      } catch (const InputError& error) {
        data_.left_out.emplace_back(error.what());
      }
    }
    if (with_runs.runs.empty()) return;
    if (scenario) {
      with_runs.path = drawn_path(scenario->path);
      for (const SceneObstacle& obstacle : scenario->obstacles)
        with_runs.obstacles.push_back(obstacle.radius);
      for (const ScenePart& part : scenario->cell) with_runs.cell.push_back({part.name, part.shape});
      with_runs.floor = scenario->floor;
    }
    const std::size_t size = record::json_of(with_runs).size();
    if (size > room_) {
      data_.thinned.push_back(fmt::format("plots and replay of {}", shown.name));
      return;
    }
    room_ -= size;
    tell(with_runs, whole != nullptr ? whole->obstacles.size() : 0);
    shown = std::move(with_runs);
  }

  /// Returns the largest number of obstacles in a replay. They may take half the bytes of a run. A replay has
  /// at least a hundred samples, if there are as many rows.
  static std::size_t most_obstacles(std::size_t share, std::size_t rows) {
    constexpr std::size_t kBytesOfObstacle = 200;  // [bytes] of one obstacle
    constexpr std::size_t kOfSample = 8;
    return share / 2 / (kBytesOfObstacle + kOfSample * std::min<std::size_t>(rows, 100));
  }

  void tell(const ReportScenario& shown, std::size_t obstacles) {
    if (shown.obstacles.size() < obstacles) {
      few_obstacles_.push_back(shown.name);
      all_obstacles_ += obstacles;
      hidden_obstacles_ += obstacles - shown.obstacles.size();
    }
    for (const Run& run : shown.runs) {
      if (run.replay.n > 1) coarsest_ = std::max(coarsest_, run.replay.dt);
      if (run.shortest_state > 0.0) {
        data_.thinned.push_back(
            fmt::format("controller states and slerps of {} shorter than {:.3g} s, because there are too "
                        "many",
                        shown.name, run.shortest_state));
      }
    }
  }

  void tell_of_replays() {
    if (!few_obstacles_.empty()) {
      const bool one = few_obstacles_.size() == 1;
      data_.thinned.push_back(
          fmt::format("{} of {} obstacles in the replay{} of {}, those farthest from the tool",
                      hidden_obstacles_, all_obstacles_, one ? "" : "s",
                      one ? few_obstacles_[0] : fmt::format("{} scenarios", few_obstacles_.size())));
    }
    constexpr double kWorthAWord = 0.1;  // [s]
    if (coarsest_ > kWorthAWord)
      data_.thinned.push_back(fmt::format(
          "in the replays, all motion between samples, which are up to {:.3g} s apart", coarsest_));
  }

  static constexpr std::size_t kLeastOfScenario = 12'000;  // [bytes] its path and names

  const std::string& folder_;
  const Scene& scene_;
  std::size_t room_;
  ReportData& data_;
  std::vector<std::vector<File>> files_;                  ///< per scenario
  double coarsest_ = 0.0;                                 ///< step of a replay [s]
  std::vector<std::string> few_obstacles_;                ///< scenarios that show fewer than they have
  std::size_t all_obstacles_ = 0, hidden_obstacles_ = 0;  ///< of those scenarios
};

}  // namespace

std::string name_in(const SceneSet& set, const std::string& file) {
  return set.folder == "." ? file : set.folder + "/" + file;
}

void add_recordings(const std::string& folder, const Scene& scene, std::size_t room, ReportData& data) {
  Recordings(folder, scene, room, data).add();
}

}  // namespace armtune::internal::report
