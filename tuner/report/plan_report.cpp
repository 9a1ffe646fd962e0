#include "tuner/report/plan_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "armtune/error.hpp"
#include "tuner/report/nearest_obstacles.hpp"
#include "tuner/report/plan_recording.hpp"
#include "tuner/report/provenance.hpp"
#include "tuner/report/run_report.hpp"
#include "tuner/report/shorten.hpp"
#include "tuner/report/title.hpp"
#include "tuner/report/words.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::internal::report {
namespace {

constexpr std::size_t kMostNamed = 2;     // limits named in the sentence
constexpr double kBeyond = 1.001;         // share of a limit that is mentioned
constexpr double kReplaySamples = 250.0;  // per replay, if there are as many rows

/// Entries of run.yaml about the solution of the plan, with the words that the page shows.
constexpr std::pair<const char*, const char*> kFigures[] = {
    {"phases", "phases"},
    {"knots", "knots of the time grid"},
    {"violation", "largest constraint violation, relative to the limit"},
    {"kkt_stationarity", "KKT residual: stationarity"},
    {"kkt_complementarity", "KKT residual: complementarity"},
    {"interior_point_steps", "interior-point steps on all grids"},
    {"wall_seconds", "wall clock seconds"}};

class PlanAssembly {
 public:
  PlanAssembly(std::string folder, std::size_t bytes) : folder_(std::move(folder)), bytes_(bytes) {
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
    std::optional<NumberTable> motion;
    part([&] { motion = read_motion(shown); });
    part(
        [&] { shown.limits = plan_limits_of(CsvTable::read(file("limits.csv")), arm(), data_.plan->start); });
    data_.title = page_title(name(data_.kind), shown.name, folder_);
    data_.verdict = verdict(shown.limits);
    data_.scenarios.push_back(std::move(shown));
    shorten(data_);
    drop_meshes(bytes_ / 2, data_);
    if (motion) part([&] { add_run(*motion, data_.scenarios.front()); });
    add_notes(data_);
    return std::move(data_);
  }

 private:
  /// Reads one part. If its file cannot be used, only this part is left out, and the reason is listed.
  template <typename Read>
  void part(Read read) {
    try {
      read();
    } catch (const InputError& error) {
      data_.left_out.emplace_back(error.what());
    }
  }

  /// Throws InputError if the file is missing or outside the folder.
  std::string file(const std::string& name) const { return run_file(folder_, name); }

  std::string entry(const std::string& key) const { return run_.contains(key) ? run_.at(key) : ""; }

  const SceneScenario* scenario() const {
    return scene_.scenarios.empty() ? nullptr : &scene_.scenarios.front();
  }
  const Arm* arm() const { return scenario() == nullptr ? nullptr : &scene_.arms[scenario()->arm]; }

  void read_run() {
    data_.provenance.entries = read_provenance(file("run.yaml"));
    for (const auto& [key, value] : data_.provenance.entries) run_[key] = value;
    data_.provenance.command = entry("command");
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
    if (!scene.path.rests()) shown.path = drawn_path(scene.path);
    for (const ScenePart& part : scene.cell) shown.cell.push_back({part.name, part.shape});
    shown.floor = scene.floor;
  }

  NumberTable read_motion(ReportScenario& shown) {
    NumberTable motion = NumberTable::read(file("motion.csv"), [](std::string_view) { return true; });
    if (motion.rows() == 0) throw InputError(file("motion.csv") + ": the file has no rows");
    data_.plan->start = motion.number(0, motion.column("time"));
    if (shown.name.empty()) shown.name = "plan";
    return motion;
  }

  void add_run(const NumberTable& motion, ReportScenario& shown) {
    constexpr std::size_t kForNotes = 40'000;
    const std::size_t used = report_json(data_).size() + kForNotes;
    const std::size_t room = bytes_ - std::min(bytes_, used);
    const auto& time = motion.numbers(motion.column("time"));
    const double duration = time.back() - time.front();
    std::optional<SceneScenario> scene;
    if (scenario() != nullptr) {
      scene = *scenario();
      constexpr std::size_t kOfObstacle = 4000;  // [bytes] in half of the room
      keep_nearest(motion, room / kOfObstacle, *scene);
      for (const SceneObstacle& obstacle : scene->obstacles) shown.obstacles.push_back(obstacle.radius);
      if (scene->obstacles.size() < scenario()->obstacles.size())
        data_.thinned.push_back(fmt::format("{} of {} obstacles in the replay, those farthest from the tool",
                                            scenario()->obstacles.size() - scene->obstacles.size(),
                                            scenario()->obstacles.size()));
    }
    const std::size_t joints = arm() == nullptr ? 0 : arm()->joints.size();
    const std::size_t series = 7 + 2 * joints + 3 * shown.obstacles.size();
    Resolution resolution = resolution_for(room, motion.header().size(), series, duration);
    // A short motion has as many samples as a long one, if it has as many rows.
    if (duration > 0.0 && duration < 10.0)
      resolution.replay_rate = std::max(resolution.replay_rate, kReplaySamples / duration);
    Run run = plan_run_of(motion, scene ? &*scene : nullptr, arm(), resolution);
    run.status = "completed";
    shown.duration = run.end;
    shown.runs.push_back(std::move(run));
  }

  /// Returns, for example, "held back by velocity of wrist_2_joint, torque of elbow_joint".
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

  /// Returns a sentence about limits between the knots, where they are not enforced.
  static std::string between(const std::vector<PlanLimit>& limits) {
    const PlanLimit* worst = nullptr;
    for (const PlanLimit& limit : limits) {
      if (!std::isnan(limit.between_knots) &&
          (worst == nullptr || limit.between_knots > worst->between_knots))
        worst = &limit;
    }
    if (worst == nullptr) return {};
    if (worst->between_knots < kBeyond) return "Between the knots, no limit is exceeded by more than 0.1 %";
    return fmt::format(
        "Between the knots, where limits are not enforced, {} reaches {:.2f} % of its limit; more knots "
        "reduce this",
        worst->words, 100.0 * worst->between_knots);
  }

  Verdict verdict(const std::vector<PlanLimit>& limits) const {
    Verdict verdict;
    const std::string headline = entry("headline");
    verdict.sentence = joined({headline.empty() ? "the numbers of this plan could not be read" : headline,
                               headline.empty() ? "" : held_back(limits)});
    if (const std::string words = between(limits); !words.empty()) verdict.details.push_back(words);
    if (scene_.arms.empty())
      verdict.details.emplace_back("There is no replay, because the folder has no readable scene.json.");
    return verdict;
  }

  std::string folder_;
  std::size_t bytes_;
  Scene scene_;
  std::map<std::string, std::string> run_;  ///< run.yaml
  ReportData data_;
};

}  // namespace

ReportData plan_report_of(const std::string& folder, std::size_t bytes) {
  return PlanAssembly(folder, bytes).make();
}

}  // namespace armtune::internal::report
