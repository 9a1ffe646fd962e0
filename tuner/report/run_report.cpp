#include "tuner/report/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/common/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/report/plan_report.hpp"
#include "tuner/report/provenance.hpp"
#include "tuner/report/recording.hpp"
#include "tuner/report/sections.hpp"
#include "tuner/report/tables.hpp"
#include "tuner/report/title.hpp"
#include "tuner/report/verdict.hpp"
#include "tuner/study/study.hpp"

namespace armtune::report {
namespace {

namespace fs = std::filesystem;

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

std::optional<CsvTable> table_if_any(const std::string& path) {
  return exists(path) ? std::optional(CsvTable::read(path)) : std::nullopt;
}

class Assembly {
 public:
  Assembly(std::string folder, std::size_t recording_bytes, const std::optional<Live>& live)
      : folder_(std::move(folder)), recording_bytes_(recording_bytes) {
    data_.kind = kind_of(folder_);
    data_.live = live;
  }

  ReportData make() {
    part([this] { read_provenance(); });
    part([this] {
      if (exists(file("verdict.yaml"))) facts_.checks = read_verdict(file("verdict.yaml"));
    });
    part([this] {
      if (exists(file("study.yaml"))) facts_.study = read_study_facts(file("study.yaml"));
    });
    read_scene_or_guess();
    for (const SceneSet& set : scene_.sets) data_.sets.push_back(set.name);
    data_.arms = scene_.arms;
    part([this] { read_tables(); });
    part([this] { read_gains(); });
    read_recordings();
    part([this] { read_evaluations(); });
    part([this] { read_analyses(); });
    part([this] { read_many(); });
    data_.title = title();
    data_.verdict = verdict_of(data_, facts_);
    if (scene_.arms.empty() && !data_.scenarios.empty()) {
      data_.verdict.details.emplace_back("The folder holds no scene.json, so there is no replay.");
    }
    for (const std::string& why : data_.left_out) data_.verdict.details.push_back("Left out: " + why);
    show_tables();
    return std::move(data_);
  }

 private:
  /// What one file spoils is left out alone, and said.
  template <typename Read>
  void part(Read read) {
    try {
      read();
    } catch (const InputError& error) {
      data_.left_out.emplace_back(error.what());
    }
  }

  std::string file(const std::string& name) const { return folder_ + "/" + name; }
  std::string file(const SceneSet& set, const std::string& name) const {
    return file(set.folder == "." ? name : set.folder + "/" + name);
  }
  std::string entry(const std::string& key) const {
    const auto found = facts_.run.find(key);
    return found == facts_.run.end() ? std::string() : found->second;
  }

  void read_provenance() {
    facts_.ended = exists(file("run.yaml"));
    facts_.resumable = exists(file("journal.txt"));
    if (!facts_.ended) return;
    data_.provenance = report::read_provenance(file("run.yaml"));
    for (const auto& [key, value] : data_.provenance) facts_.run[key] = value;
    data_.command = entry("command");
  }

  std::string title() const {
    const std::string study = entry("study");
    return page_title(report::name(data_.kind), study.empty() ? study : stem(study), folder_);
  }

  void read_scene_or_guess() {
    part([this] {
      if (exists(file("scene.json"))) scene_ = read_scene(file("scene.json"));
    });
    if (!scene_.sets.empty()) return;
    part([this] { scene_.sets = usual_sets(data_.kind, folder_); });
    if (!facts_.study) return;
    try {
      const Study study = load_study(file("study.yaml"));
      scene_ = scene_of(study.scenarios, scene_.sets, study.space.start.obstacleInfluenceRadius);
    } catch (const InputError&) {  // the files that it names are elsewhere by now
    }
  }

  void read_tables() {
    std::vector<std::optional<CsvTable>> errors;
    for (const SceneSet& set : scene_.sets) errors.push_back(table_if_any(file(set.errors)));
    data_.tables = tables_of(errors);
    auto judged = tables_of(of_sets("robust_errors.csv"));
    // Each metric is measured over the arms by itself: joint and time of a ratio are of no one arm.
    for (Table& table : judged) {
      for (MetricRow& row : table.rows) row.text.clear();
    }
    if (!judged.empty()) data_.judged = {facts_.study ? facts_.study->measure : "", std::move(judged)};
  }

  /// Those that a person looks at first and those that the study asks for: every other is in the files.
  void show_tables() {
    const auto wanted = facts_.study ? metrics_of(*facts_.study) : std::vector<Metric>();
    keep_rows(data_.tables, wanted);
    if (data_.judged) keep_rows(data_.judged->tables, wanted);
  }

  /// In the order of the file's columns; from any recording where the folder says no more.
  std::vector<std::string> joint_names() const {
    std::vector<std::string> names;
    if (!scene_.arms.empty()) {
      for (const ArmJoint& joint : scene_.arms.front().joints) names.push_back(joint.name);
      return names;
    }
    for (const SceneSet& set : scene_.sets) {
      for (const Table& table : data_.tables) {
        const std::string path = file(set, "rollout_" + table.scenario + ".csv");
        if (!exists(path)) continue;
        return joints_of(CsvTable::read(path));
      }
    }
    return names;
  }

  void read_gains() {
    if (!facts_.study) return;
    const std::vector<std::string> joints = joint_names();
    if (joints.empty()) return;
    std::vector<std::string> paths;
    for (const SceneSet& set : scene_.sets) paths.push_back(file(set, "gains.yaml"));
    data_.gains = gains_of(facts_.study->gains, joints, paths);
  }

  const SceneScenario* scenario(const std::string& name) const {
    for (const SceneScenario& s : scene_.scenarios) {
      if (s.name == name) return &s;
    }
    return nullptr;
  }

  /// Names of the scenarios: the scene's, else the tables'.
  std::vector<std::string> scenario_names() const {
    std::vector<std::string> names;
    for (const SceneScenario& s : scene_.scenarios) names.push_back(s.name);
    if (!names.empty()) return names;
    for (const Table& table : data_.tables) names.push_back(table.scenario);
    return names;
  }

  void read_recordings() {
    const auto names = scenario_names();
    std::size_t runs = 0;
    double seconds = 0.0;
    for (const std::string& name : names) {
      for (const SceneSet& set : scene_.sets) {
        if (!exists(file(set, "rollout_" + name + ".csv"))) continue;
        ++runs;
        if (const SceneScenario* s = scenario(name)) seconds += s->duration;
      }
    }
    std::size_t joints = 0;
    for (const Arm& arm : scene_.arms) joints = std::max(joints, arm.joints.size());
    const Resolution resolution = resolution_for(runs, 22 + 2 * joints, seconds, recording_bytes_);
    for (const std::string& name : names) add_scenario(name, resolution);
  }

  void add_scenario(const std::string& name, const Resolution& resolution) {
    ReportScenario shown;
    shown.name = name;
    const SceneScenario* s = scenario(name);
    const Arm* arm = s != nullptr ? &scene_.arms[s->arm] : nullptr;
    if (s != nullptr) {
      shown.arm = static_cast<long>(s->arm);
      shown.duration = s->duration;
      shown.influence_radius = s->influence_radius;
      for (const SceneObstacle& obstacle : s->obstacles) shown.obstacles.push_back(obstacle.radius);
      shown.path = drawn_path(s->path);
    }
    for (std::size_t set = 0; set < scene_.sets.size(); ++set) {
      const std::string path = file(scene_.sets[set], "rollout_" + name + ".csv");
      const std::string status = of_set(name, set, &Table::status);
      if (!exists(path)) {
        // What was given up or interrupted leaves none.
        if (status == "completed")
          data_.left_out.push_back(path + ": is not there; so are its plots and replay");
        continue;
      }
      part([&] {
        const CsvTable recording = CsvTable::read(path);
        Run run = run_of(recording, s, arm, resolution);
        // Between two rows the end may lie, but not further off.
        const double row_after =
            run.end * (1.0 + 1.5 / static_cast<double>(std::max<std::size_t>(1, recording.rows() - 1)));
        if (s != nullptr && status == "completed" && row_after < s->duration) {
          data_.left_out.push_back(fmt::format("{}: what comes after {:.3f} s of {:.6g} s; it was cut off",
                                               path, run.end, s->duration));
        }
        run.set = set;
        run.status = status;
        run.reason = of_set(name, set, &Table::reason);
        if (run.reason.empty() && !run.status.empty() && run.status != "completed") {
          run.reason = fmt::format("{} at {:.3f} s", run.status, run.end);
        }
        if (s == nullptr) shown.duration = std::max(shown.duration, run.end);
        shown.runs.push_back(std::move(run));
      });
    }
    data_.scenarios.push_back(std::move(shown));
  }

  /// An entry of a scenario's table; empty where there is none.
  std::string of_set(const std::string& scenario, std::size_t set,
                     std::vector<std::string> Table::*entries) const {
    for (const Table& table : data_.tables) {
      if (table.scenario == scenario && set < (table.*entries).size()) return (table.*entries)[set];
    }
    return {};
  }

  void read_evaluations() {
    const auto table = table_if_any(file("evaluations.csv"));
    if (!table) return;
    data_.evaluations = evaluations_of(*table, data_.gains);
    if (data_.kind == RunKind::kPareto) data_.evaluations->chosen = -1;  // a front chooses none
    if (data_.kind != RunKind::kTune) return;
    data_.front = front_of_search(*table, *data_.evaluations,
                                  facts_.study ? facts_.study->limits : std::vector<StudyLimit>());
  }

  /// A file of each set; none where there is no such file.
  std::vector<std::optional<CsvTable>> of_sets(const char* name) const {
    std::vector<std::optional<CsvTable>> tables;
    for (const SceneSet& set : scene_.sets) tables.push_back(table_if_any(file(set, name)));
    return tables;
  }

  void read_analyses() {
    if (const auto sensitivity = table_if_any(file("sensitivity.csv"))) {
      data_.sensitivity = sensitivity_of(*sensitivity);
    }
    data_.margins = margins_of(of_sets("margins.csv"));
    part([this] { data_.yardstick = yardstick_of(of_sets("yardstick.csv")); });
  }

  void read_many() {
    if (data_.kind == RunKind::kPareto && exists(file("pareto.csv"))) read_front();
    name_start();
    if (data_.kind != RunKind::kRobustness) return;
    if (const auto samples = table_if_any(file("samples.csv"))) {
      data_.robustness = robustness_of(*samples, entry("limits"), data_.tables);
    }
  }

  /// "start (published)"
  void name_start() {
    const std::string start = entry("start");
    if (!data_.front || start.empty()) return;
    for (FrontPoint& point : data_.front->points) {
      if (point.role == "start") point.label = fmt::format("start ({})", start);
    }
  }

  void read_front() {
    std::vector<std::string> criteria;
    std::istringstream words(entry("criteria"));
    for (std::string word; words >> word;) criteria.push_back(word);
    if (criteria.empty()) return;  // killed before run.yaml was written
    const std::string text = entry("hypervolume");
    const std::string last = data_.sets.empty() ? std::string() : data_.sets.back();
    constexpr std::string_view kPoint = "point ";
    data_.front = front_of(CsvTable::read(file("pareto.csv")), criteria,
                           last.starts_with(kPoint) ? last.substr(kPoint.size()) : std::string(),
                           text.empty() ? std::nullopt : std::optional(std::strtod(text.c_str(), nullptr)));
  }

  std::string folder_;
  std::size_t recording_bytes_;
  Scene scene_;
  VerdictFacts facts_;
  ReportData data_;
};

}  // namespace

ReportData report_of(const std::string& folder, std::size_t recording_bytes,
                     const std::optional<Live>& live) {
  return kind_of(folder) == RunKind::kPlan ? plan_report_of(folder, recording_bytes)
                                           : Assembly(folder, recording_bytes, live).make();
}

}  // namespace armtune::report
