#include "tuner/report/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/report/calibration_report.hpp"
#include "tuner/report/kind_of_folder.hpp"
#include "tuner/report/plan_report.hpp"
#include "tuner/report/record_entries.hpp"
#include "tuner/report/recording.hpp"
#include "tuner/report/run_recordings.hpp"
#include "tuner/report/sections.hpp"
#include "tuner/report/shorten.hpp"
#include "tuner/report/tables.hpp"
#include "tuner/report/title.hpp"
#include "tuner/report/validation_report.hpp"
#include "tuner/report/verdict.hpp"
#include "tuner/report/words.hpp"
#include "tuner/robustness/limits.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::internal::report {
namespace {

class Assembly {
 public:
  Assembly(std::string folder, std::size_t bytes, const std::optional<Live>& live)
      : folder_(std::move(folder)), bytes_(bytes) {
    data_.kind = kind_of(folder_);
    data_.live = live;
  }

  ReportData make() {
    part([this] { facts_.resumable = find("journal.txt").has_value(); });
    part([this] { read_record(); });
    part([this] {
      if (const auto path = find("verdict.yaml")) facts_.checks = read_verdict(*path);
    });
    part([this] {
      if (const auto path = find("study.yaml")) facts_.study = read_study_facts(*path);
    });
    part([this] {
      if (const auto path = find("scene.json")) scene_ = read_scene(*path);
    });
    if (scene_.sets.empty()) part([this] { scene_.sets = usual_sets(data_.kind, folder_); });
    for (const SceneSet& set : scene_.sets) data_.sets.push_back(set.name);
    data_.arms = scene_.arms;
    part([this] { read_tables(); });
    part([this] { read_gains(); });
    describe_scenarios();
    part([this] { read_evaluations(); });
    part([this] { read_analyses(); });
    part([this] { read_many(); });
    data_.title = title();
    data_.verdict = verdict_of(data_, facts_);
    if (scene_.arms.empty() && !data_.scenarios.empty()) {
      data_.verdict.details.emplace_back(
          "There is no replay, because the folder has no readable scene.json.");
    }
    fill();
    return std::move(data_);
  }

 private:
  /// Shortens the other sections if they are very long. The recordings then get the remaining bytes.
  void fill() {
    constexpr std::size_t kForNotes = 40'000;
    const std::vector<Table> tables = data_.tables;
    show_tables();
    shorten(data_);
    drop_meshes(bytes_ - std::min(bytes_, bytes_ / 4 + kForNotes), data_);
    const std::size_t used = report_json(data_).size() + kForNotes;
    std::vector<Table> shown = std::exchange(data_.tables, tables);
    add_recordings(folder_, scene_, bytes_ - std::min(bytes_, used), data_);
    data_.tables = std::move(shown);
    add_notes(data_);
  }

  /// Reads one part. If its file cannot be used, only this part is left out, and the reason is listed.
  template <typename Read>
  void part(Read read) {
    try {
      read();
    } catch (const InputError& error) {
      data_.left_out.emplace_back(error.what());
    }
  }

  std::optional<std::string> find(const std::string& name) const { return find_run_file(folder_, name); }
  std::optional<CsvTable> table_if_any(const std::string& name) const {
    const auto path = find(name);
    return path ? std::optional(CsvTable::read(*path)) : std::nullopt;
  }
  void read_record() {
    facts_.ended = true;  // unless the record is missing; an unreadable one belongs to a run that has ended
    refuse_old_record(folder_);
    facts_.record = find_run_record(folder_);
    facts_.ended = facts_.record.has_value();
    if (facts_.record) data_.provenance = provenance_of(*facts_.record);
  }

  std::string title() const {
    const SearchFacts* search = facts_.search();
    return page_title(internal::name(data_.kind), search != nullptr ? stem(search->study) : "", folder_);
  }

  void read_tables() {
    std::vector<std::optional<CsvTable>> errors;
    for (const SceneSet& set : scene_.sets) errors.push_back(table_if_any(set.errors));
    data_.tables = tables_of(errors);
    auto judged = tables_of(of_sets("robust_errors.csv"));
    // Each metric is combined over the arms separately. Joint and time of a ratio thus belong to no single
    // arm.
    for (Table& table : judged) {
      for (MetricRow& row : table.rows) row = {row.metric, row.values, {}, {}};
    }
    if (!judged.empty()) data_.judged = {facts_.study ? facts_.study->measure : "", std::move(judged)};
  }

  /// Keeps the headline metrics and those of the study. The files have all others.
  void show_tables() {
    const auto wanted = facts_.study ? metrics_of(*facts_.study) : std::vector<Metric>();
    keep_rows(data_.tables, wanted);
    if (data_.judged) keep_rows(data_.judged->tables, wanted);
  }

  /// Returns the joints of the scene or, without a scene, those of any recording, in the order of its
  /// columns.
  std::vector<std::string> joint_names() const {
    std::vector<std::string> names;
    if (!scene_.arms.empty()) {
      for (const ArmJoint& joint : scene_.arms.front().joints) names.push_back(joint.name);
      return names;
    }
    for (const SceneSet& set : scene_.sets) {
      for (const Table& table : data_.tables) {
        const auto path = find(name_in(set, "rollout_" + table.scenario + ".csv"));
        if (path) return joints_of(read_recording(*path));
      }
    }
    return names;
  }

  void read_gains() {
    if (!facts_.study) return;
    const std::vector<std::string> joints = joint_names();
    if (joints.empty()) return;
    std::vector<std::optional<std::string>> paths;
    for (const SceneSet& set : scene_.sets) paths.push_back(find(name_in(set, "gains.yaml")));
    data_.gains = gains_of(facts_.study->gains, joints, paths);
  }

  /// Adds the scenarios of the scene or, without a scene, those of the tables. Adds no recordings.
  void describe_scenarios() {
    for (const SceneScenario& s : scene_.scenarios) {
      ReportScenario& shown = data_.scenarios.emplace_back();
      shown.name = s.name;
      shown.arm = static_cast<long>(s.arm);
      shown.duration = s.duration;
      shown.influence_radius = s.influence_radius;
    }
    if (!data_.scenarios.empty()) return;
    for (const Table& table : data_.tables) data_.scenarios.emplace_back().name = table.scenario;
  }

  void read_evaluations() {
    const auto table = table_if_any("evaluations.csv");
    if (!table) return;
    data_.evaluations = evaluations_of(*table, data_.gains);
    if (data_.kind == RunKind::kPareto) data_.evaluations->chosen = -1;  // a front chooses none
    if (data_.kind != RunKind::kTune) return;
    data_.front = front_of_search(*table, *data_.evaluations,
                                  facts_.study ? facts_.study->limits : std::vector<StudyLimit>());
  }

  /// Returns the file of this name of each gain set, or nothing for a set that does not have it.
  std::vector<std::optional<CsvTable>> of_sets(const char* name) const {
    std::vector<std::optional<CsvTable>> tables;
    for (const SceneSet& set : scene_.sets) tables.push_back(table_if_any(name_in(set, name)));
    return tables;
  }

  void read_analyses() {
    if (const auto sensitivity = table_if_any("sensitivity.csv")) {
      data_.sensitivity = sensitivity_of(*sensitivity);
    }
    data_.margins = margins_of(of_sets("margins.csv"));
    part([this] { data_.yardstick = yardstick_of(of_sets("yardstick.csv")); });
  }

  void read_many() {
    if (data_.kind == RunKind::kPareto && find("pareto.csv")) read_front();
    name_start();
    if (data_.kind != RunKind::kRobustness) return;
    if (const auto samples = table_if_any("samples.csv")) {
      data_.robustness = robustness_of(*samples, limits_of_arms(), data_.tables);
    }
  }

  /// Returns the limits that the arms had to keep. Metrics that only another version of armtune has are left
  /// out.
  std::vector<MetricLimit> limits_of_arms() const {
    if (!facts_.record || !facts_.record->robustness) return arm_limits();
    std::vector<MetricLimit> limits;
    for (const LimitFact& limit : facts_.record->robustness->limits) {
      if (const auto metric = metric_from_name(limit.metric))
        limits.push_back({*metric, limit.upper, limit.value});
    }
    return limits;
  }

  /// Labels the start as, for example, "start (published)".
  void name_start() {
    const std::string start = facts_.search() != nullptr ? facts_.search()->start : "";
    if (!data_.front || start.empty()) return;
    for (FrontPoint& point : data_.front->points) {
      if (point.role == "start") point.label = fmt::format("start ({})", start);
    }
  }

  void read_front() {
    if (!facts_.record || !facts_.record->front) return;  // killed before run.json was written
    const FrontFacts& found = *facts_.record->front;
    const auto shown = scene_.sets.empty() ? std::nullopt : scene_.sets.back().point;
    data_.front = front_of(CsvTable::read(run_file(folder_, "pareto.csv")), found.criteria,
                           shown ? std::to_string(*shown) : std::string(), found.hypervolume);
  }

  std::string folder_;
  std::size_t bytes_;
  Scene scene_;
  VerdictFacts facts_;
  ReportData data_;
};

}  // namespace

void add_notes(ReportData& data) {
  constexpr std::size_t kMost = 30;
  const auto lines = [](const std::vector<std::string>& items, const char* what) {
    std::vector<std::string> told;
    told.reserve(items.size());
    for (const std::string& item : items) told.push_back(what + item);
    return told;
  };
  add(data.verdict.details, lines(data.left_out, "Left out: "), kMost);
  add(data.verdict.details, lines(data.thinned, "Left out to keep this page small: "), kMost);
}

ReportData report_of(const std::string& folder, std::size_t bytes, const std::optional<Live>& live) {
  const RunKind kind = kind_of(folder);
  if (kind == RunKind::kPlan) return plan_report_of(folder, bytes);
  if (kind == RunKind::kValidate) return validation_report_of(folder, bytes);
  if (kind == RunKind::kCalibrate) return calibration_report_of(folder);
  return Assembly(folder, bytes, live).make();
}

}  // namespace armtune::internal::report
