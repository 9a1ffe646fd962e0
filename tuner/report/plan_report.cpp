#include "tuner/report/plan_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"
#include "tuner/report/nearest_obstacles.hpp"
#include "tuner/report/plan_recording.hpp"
#include "tuner/report/record_entries.hpp"
#include "tuner/report/run_report.hpp"
#include "tuner/report/shorten.hpp"
#include "tuner/report/title.hpp"
#include "tuner/report/words.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::report {
namespace {

constexpr std::size_t kMostNamed = 2;     // limits named in the sentence
constexpr double kBeyond = 1.001;         // share of a limit that is mentioned
constexpr double kReplaySamples = 250.0;  // per replay, if there are as many rows

/// Returns the solution of the plan in numbers, with the words that the page shows.
std::vector<std::pair<std::string, std::string>> figures_of(const PlanFacts& plan, double wall_seconds) {
  std::vector<std::string> phases;
  phases.reserve(plan.phases.size());
  for (const PhaseFact& phase : plan.phases)
    phases.push_back(fmt::format("{} {:.6g} s", phase.name, phase.duration));
  return {{"phases", fmt::format("{}", fmt::join(phases, ", "))},
          {"knots of the time grid", fmt::format("{}", plan.knots)},
          {"largest constraint violation, relative to the limit", fmt::format("{:.3g}", plan.violation)},
          {"KKT residual: stationarity", fmt::format("{:.3g}", plan.stationarity)},
          {"KKT residual: complementarity", fmt::format("{:.3g}", plan.complementarity)},
          {"interior-point steps on all grids", fmt::format("{}", plan.interior_point_steps)},
          {"wall clock seconds", fmt::format("{:.3f}", wall_seconds)}};
}

class PlanAssembly {
 public:
  PlanAssembly(std::string folder, std::size_t bytes) : folder_(std::move(folder)), bytes_(bytes) {
    data_.kind = RunKind::kPlan;
    data_.plan.emplace();
  }

  ReportData make() {
    part([this] { read_record(); });
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

  const SceneScenario* scenario() const {
    return scene_.scenarios.empty() ? nullptr : &scene_.scenarios.front();
  }
  const Arm* arm() const { return scenario() == nullptr ? nullptr : &scene_.arms[scenario()->arm]; }

  void read_record() {
    refuse_old_record(folder_);
    const auto record = find_run_record(folder_);
    if (!record) throw InputError(InputPlace{folder_ + "/" + kRunRecord}, "there is no such file");
    data_.provenance = provenance_of(*record);
    if (!record->plan) return;
    headline_ = record->plan->headline;
    data_.plan->scenario = record->plan->scenario;
    data_.plan->figures = figures_of(*record->plan, record->wall_seconds);
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
    verdict.sentence = joined({headline_.empty() ? "the numbers of this plan could not be read" : headline_,
                               headline_.empty() ? "" : held_back(limits)});
    if (const std::string words = between(limits); !words.empty()) verdict.details.push_back(words);
    if (scene_.arms.empty())
      verdict.details.emplace_back("There is no replay, because the folder has no readable scene.json.");
    return verdict;
  }

  std::string folder_;
  std::size_t bytes_;
  Scene scene_;
  std::string headline_;  ///< the result of the plan as a sentence; empty if it is unknown
  ReportData data_;
};

}  // namespace

ReportData plan_report_of(const std::string& folder, std::size_t bytes) {
  return PlanAssembly(folder, bytes).make();
}

}  // namespace armtune::internal::report
