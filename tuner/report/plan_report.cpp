#include "tuner/report/plan_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/common/error.hpp"
#include "tuner/report/plan_recording.hpp"
#include "tuner/report/provenance.hpp"
#include "tuner/report/title.hpp"
#include "tuner/report/words.hpp"

namespace armtune::report {
namespace {

constexpr std::size_t kMostNamed = 2;     // in the sentence
constexpr double kBeyond = 1.001;         // of a limit: what is worth a word
constexpr double kReplaySamples = 250.0;  // of a motion of any length, where it has as many rows

/// Entries of run.yaml that say how the plan was solved, in a reader's words.
constexpr std::pair<const char*, const char*> kFigures[] = {
    {"phases", "phases"},
    {"knots", "knots of the time grid"},
    {"violation", "largest constraint violation, of the limit"},
    {"kkt_stationarity", "KKT residual: stationarity"},
    {"kkt_complementarity", "KKT residual: complementarity"},
    {"interior_point_steps", "interior point steps on all grids"},
    {"wall_seconds", "seconds"}};

class PlanAssembly {
 public:
  PlanAssembly(std::string folder, std::size_t recording_bytes)
      : folder_(std::move(folder)), recording_bytes_(recording_bytes) {
    data_.kind = RunKind::kPlan;
    data_.plan.emplace();
  }

  ReportData make() {
    part([this] { read_run(); });
    part([this] { scene_ = read_scene(file("scene.json")); });
    data_.arms = scene_.arms;
    data_.sets = {"plan"};
    ReportScenario shown;
    if (!scene_.scenarios.empty()) describe(scene_.scenarios.front(), shown);
    part([&] { read_motion(shown); });
    part(
        [&] { shown.limits = plan_limits_of(CsvTable::read(file("limits.csv")), arm(), data_.plan->start); });
    data_.title = page_title(name(data_.kind), shown.name, folder_);
    data_.verdict = verdict(shown.limits);
    data_.scenarios.push_back(std::move(shown));
    for (const std::string& why : data_.left_out) data_.verdict.details.push_back("Left out: " + why);
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

  std::string entry(const std::string& key) const {
    const auto found = run_.find(key);
    return found == run_.end() ? std::string() : found->second;
  }

  const SceneScenario* scenario() const {
    return scene_.scenarios.empty() ? nullptr : &scene_.scenarios.front();
  }
  const Arm* arm() const { return scenario() == nullptr ? nullptr : &scene_.arms[scenario()->arm]; }

  void read_run() {
    data_.provenance = read_provenance(file("run.yaml"));
    for (const auto& [key, value] : data_.provenance) run_[key] = value;
    data_.command = entry("command");
    data_.plan->scenario = entry("scenario");
    for (const auto& [key, words] : kFigures) {
      if (const std::string value = entry(key); !value.empty())
        data_.plan->figures.emplace_back(words, value);
    }
  }

  void describe(const SceneScenario& scene, ReportScenario& shown) const {
    shown.name = scene.name;
    shown.arm = static_cast<long>(scene.arm);
    shown.influence_radius = scene.influence_radius;
    for (const SceneObstacle& obstacle : scene.obstacles) shown.obstacles.push_back(obstacle.radius);
    if (!scene.path.rests()) shown.path = drawn_path(scene.path);
  }

  void read_motion(ReportScenario& shown) {
    const CsvTable motion = CsvTable::read(file("motion.csv"));
    if (motion.rows() == 0) throw InputError(file("motion.csv") + ": has no row");
    const std::size_t time = motion.column("time");
    data_.plan->start = motion.number(0, time);
    const double duration = motion.number(motion.rows() - 1, time) - data_.plan->start;
    Resolution resolution = resolution_for(1, motion.header().size(), duration, recording_bytes_);
    resolution.replay_rate = std::max(resolution.replay_rate, kReplaySamples / duration);
    Run run = plan_run_of(motion, scenario(), arm(), resolution);
    run.status = "completed";
    shown.duration = run.end;
    if (shown.name.empty()) shown.name = "plan";
    shown.runs.push_back(std::move(run));
  }

  /// "held back by velocity of wrist_2_joint and torque of elbow_joint"
  static std::string held_back(const std::vector<PlanLimit>& limits) {
    std::string words;
    std::size_t named = 0;
    std::size_t active = 0;
    for (const PlanLimit& limit : limits) {
      if (!(limit.strength > 0.0)) continue;
      if (++active > kMostNamed) continue;
      words += (named++ == 0 ? "held back by " : ", ") + limit.words;
    }
    if (active > named) words += fmt::format(" and {} more limits", active - named);
    return words;
  }

  /// What the limits that hold at the knots only do between them.
  static std::string between(const std::vector<PlanLimit>& limits) {
    const PlanLimit* worst = nullptr;
    for (const PlanLimit& limit : limits) {
      if (!std::isnan(limit.between_knots) &&
          (worst == nullptr || limit.between_knots > worst->between_knots))
        worst = &limit;
    }
    if (worst == nullptr) return {};
    if (worst->between_knots < kBeyond)
      return "Between its knots, too, no limit is exceeded by more than 0.1 %";
    return fmt::format(
        "Between its knots, where limits are not enforced, {} reaches {:.2f} % of its limit; more knots "
        "bring it down",
        worst->words, 100.0 * worst->between_knots);
  }

  Verdict verdict(const std::vector<PlanLimit>& limits) const {
    Verdict verdict;
    const std::string headline = entry("headline");
    verdict.sentence = joined({headline.empty() ? "the figures of this plan could not be read" : headline,
                               headline.empty() ? "" : held_back(limits)});
    if (const std::string words = between(limits); !words.empty()) verdict.details.push_back(words);
    if (scene_.arms.empty())
      verdict.details.emplace_back("The folder's scene.json is missing, so there is no replay.");
    return verdict;
  }

  std::string folder_;
  std::size_t recording_bytes_;
  Scene scene_;
  std::map<std::string, std::string> run_;  ///< run.yaml
  ReportData data_;
};

}  // namespace

ReportData plan_report_of(const std::string& folder, std::size_t recording_bytes) {
  return PlanAssembly(folder, recording_bytes).make();
}

}  // namespace armtune::report
