#include "tuner/report/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "core/common/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/report/provenance.hpp"
#include "tuner/report/recording.hpp"
#include "tuner/report/sections.hpp"
#include "tuner/report/tables.hpp"
#include "tuner/report/verdict.hpp"
#include "tuner/study/study.hpp"

namespace armtune::report {
namespace {

namespace fs = std::filesystem;

/// Of the page's 6 MB, beside its program.
constexpr std::size_t kRecordingBytes = 4'000'000;

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

std::optional<CsvTable> table_if_any(const std::string& path) {
  return exists(path) ? std::optional(CsvTable::read(path)) : std::nullopt;
}

class Assembly {
 public:
  explicit Assembly(std::string folder) : folder_(std::move(folder)) { data_.kind = kind_of(folder_); }

  ReportData make() {
    read_provenance();
    if (exists(file("study.yaml"))) facts_.study = read_study_facts(file("study.yaml"));
    read_scene_or_guess();
    for (const SceneSet& set : scene_.sets) data_.sets.push_back(set.name);
    read_tables();
    read_gains();
    read_recordings();
    read_sections();
    data_.title = title();
    data_.verdict = verdict_of(data_, facts_);
    if (scene_.arms.empty()) {
      data_.verdict.details.emplace_back("The folder holds no scene.json, so there is no replay.");
    }
    return std::move(data_);
  }

 private:
  std::string file(const std::string& name) const { return folder_ + "/" + name; }
  std::string file(const SceneSet& set, const std::string& name) const {
    return file(set.folder == "." ? name : set.folder + "/" + name);
  }
  std::string entry(const std::string& key) const {
    const auto found = facts_.run.find(key);
    return found == facts_.run.end() ? std::string() : found->second;
  }

  void read_provenance() {
    if (!exists(file("run.yaml"))) return;  // a run that was killed
    data_.provenance = report::read_provenance(file("run.yaml"));
    for (const auto& [key, value] : data_.provenance) facts_.run[key] = value;
    data_.command = entry("command");
  }

  std::string title() const {
    const std::string study = entry("study");
    const std::string what = study.empty() ? std::string() : stem(study);
    const std::string name = fs::path(folder_).lexically_normal().filename().string();
    return fmt::format("{}{}{}", report::name(data_.kind), what.empty() ? "" : " " + what,
                       name.empty() || name == "." ? "" : fmt::format(" ({})", name));
  }

  std::vector<SceneSet> usual_sets() const {
    if (data_.kind == RunKind::kTune)
      return {{"start", "start", "start/errors.csv"}, {"tuned", ".", "errors.csv"}};
    if (data_.kind == RunKind::kPareto) return {{"start", "start", "start/errors.csv"}};
    if (data_.kind == RunKind::kSimulate) return {{"gains", ".", "errors.csv"}};
    if (data_.kind == RunKind::kRobustness) return {{"gains", "nominal", "nominal/errors.csv"}};
    std::vector<SceneSet> sets;
    const CsvTable comparison = CsvTable::read(file("comparison.csv"));
    for (std::size_t c = 3; c < comparison.header().size(); ++c) {
      const std::string& name = comparison.header()[c];
      if (name.ends_with("/ratio")) break;
      sets.push_back({name, "rollouts_" + name, "errors_" + name + ".csv"});
    }
    return sets;
  }

  void read_scene_or_guess() {
    if (exists(file("scene.json"))) {
      scene_ = read_scene(file("scene.json"));
      return;
    }
    scene_.sets = usual_sets();
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
    std::vector<std::optional<CsvTable>> robust;
    for (const SceneSet& set : scene_.sets) robust.push_back(table_if_any(file(set, "robust_errors.csv")));
    facts_.judged = tables_of(robust);
  }

  void read_gains() {
    if (!facts_.study || scene_.arms.empty()) return;
    std::vector<std::string> joints;
    for (const ArmJoint& joint : scene_.arms.front().joints) joints.push_back(joint.name);
    const auto entries = gain_entries(joints);
    std::vector<std::optional<Gains>> gains;
    for (const SceneSet& set : scene_.sets) {
      const std::string path = file(set, "gains.yaml");
      gains.push_back(exists(path) ? std::optional(load_gains(path, joints)) : std::nullopt);
    }
    for (const StudyGain& g : facts_.study->gains) {
      const auto found =
          std::find_if(entries.begin(), entries.end(), [&g](const GainEntry& e) { return e.name == g.name; });
      if (found == entries.end()) continue;
      Gain gain{g.name, found->field->unit, g.lower, g.upper, g.scale, {}};
      for (const auto& set : gains) gain.values.push_back(set ? value(*set, *found) : NAN);
      data_.gains.push_back(std::move(gain));
    }
  }

  const SceneScenario* scenario(const std::string& name) const {
    const auto found = std::find_if(scene_.scenarios.begin(), scene_.scenarios.end(),
                                    [&name](const SceneScenario& s) { return s.name == name; });
    return found == scene_.scenarios.end() ? nullptr : &*found;
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
    if (!scene_.arms.empty()) data_.arm = scene_.arms.front();
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
    const std::size_t columns = 22 + 2 * data_.arm.joints.size();
    const Resolution resolution = resolution_for(runs, columns, seconds, kRecordingBytes);
    for (const std::string& name : names) add_scenario(name, resolution);
  }

  void add_scenario(const std::string& name, const Resolution& resolution) {
    ReportScenario shown;
    shown.name = name;
    const SceneScenario* s = scenario(name);
    const Arm* arm = s != nullptr ? &scene_.arms[s->arm] : nullptr;
    if (s != nullptr) {
      shown.duration = s->duration;
      shown.influence_radius = s->influence_radius;
      shown.obstacles = s->obstacles.size();
      shown.path = closed_path(s->path);
    }
    for (std::size_t set = 0; set < scene_.sets.size(); ++set) {
      const std::string path = file(scene_.sets[set], "rollout_" + name + ".csv");
      if (!exists(path)) continue;
      const CsvTable rollout = CsvTable::read(path);
      Run run = run_of(rollout, s, arm, resolution);
      run.set = set;
      run.status = status(name, set);
      if (!run.status.empty() && run.status != "completed" && rollout.rows() > 0) {
        run.reason = fmt::format("{} after {:.3f} s", run.status,
                                 rollout.number(rollout.rows() - 1, rollout.column("time")));
      }
      // The page knows one arm: a scenario with another one has plots, but no replay.
      if (s != nullptr && s->arm != 0) run.replay = {};
      if (s == nullptr && rollout.rows() > 0) {
        shown.duration = std::max(shown.duration, rollout.number(rollout.rows() - 1, rollout.column("time")));
      }
      shown.runs.push_back(std::move(run));
    }
    data_.scenarios.push_back(std::move(shown));
  }

  std::string status(const std::string& scenario, std::size_t set) const {
    for (const Table& table : data_.tables) {
      if (table.scenario == scenario && set < table.status.size()) return table.status[set];
    }
    return {};
  }

  /// One period; a single point where the path is at rest.
  static std::vector<Vec3> closed_path(const HarmonicPath& path) {
    constexpr int kPoints = 180;
    std::vector<Vec3> points;
    if (path.frequency == 0.0 || path.terms.empty()) return {path.at(0.0).position};
    const double period = 2.0 * M_PI / std::abs(path.frequency);
    points.reserve(kPoints);
    for (int i = 0; i < kPoints; ++i) points.push_back(path.at(period * i / kPoints).position);
    return points;
  }

  void read_sections() {
    if (const auto evaluations = table_if_any(file("evaluations.csv"))) {
      data_.evaluations = evaluations_of(*evaluations, data_.gains);
      if (data_.kind == RunKind::kTune) data_.front = front_of_search(*evaluations, *data_.evaluations);
    }
    if (const auto sensitivity = table_if_any(file("sensitivity.csv"))) {
      data_.sensitivity = sensitivity_of(*sensitivity);
    }
    std::vector<std::optional<CsvTable>> margins;
    for (const SceneSet& set : scene_.sets) margins.push_back(table_if_any(file(set, "margins.csv")));
    data_.margins = margins_of(margins);
    if (data_.kind == RunKind::kPareto) read_front();
    if (data_.kind == RunKind::kRobustness) {
      data_.robustness = robustness_of(CsvTable::read(file("samples.csv")), entry("limits"), data_.tables);
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
  Scene scene_;
  VerdictFacts facts_;
  ReportData data_;
};

}  // namespace

RunKind kind_of(const std::string& folder) {
  const auto has = [&folder](const char* name) { return exists(folder + "/" + name); };
  if (!exists(folder)) throw InputError(folder + ": there is no such folder; give one that a run has left");
  if (has("pareto.csv")) return RunKind::kPareto;
  if (has("samples.csv")) return RunKind::kRobustness;
  if (has("comparison.csv")) return RunKind::kCompare;
  if (has("evaluations.csv")) return RunKind::kTune;
  if (has("errors.csv")) return RunKind::kSimulate;
  throw InputError(
      folder +
      ": holds none of errors.csv, evaluations.csv, pareto.csv, samples.csv and comparison.csv; give the "
      "folder of a run of simulate, tune, pareto, robustness or compare");
}

ReportData report_of(const std::string& folder) {
  return Assembly(folder).make();
}

}  // namespace armtune::report
