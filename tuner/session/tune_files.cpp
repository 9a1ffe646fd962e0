#include "tuner/session/tune_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "sim/controller_files/changed_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/controller_files/parameter_file.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/rollout/columns.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/yaml/document.hpp"
#include "tuner/evaluation/evaluations_file.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/rollouts/simulate.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/search/last_steps.hpp"
#include "tuner/session/study_files.hpp"
#include "tuner/verdict/search_checks.hpp"

namespace armtune::internal {
namespace {

/// Returns the first words of a gains file, which say what its gains are.
const char* title_of(SearchOutcome outcome) {
  switch (outcome) {
    case SearchOutcome::kTuned:
      return "tuned by armtune";
    case SearchOutcome::kStart:
      return "start gains: armtune found nothing better";
    case SearchOutcome::kLeastViolation:
      return "NOT feasible: of all gains that armtune tried, these violate the constraints least";
  }
  return "";
}

/// Returns the name of a file, with "ros_" in front if the run folder may have a file of this name itself.
std::string name_beside_results(const std::string& path) {
  const std::filesystem::path name = std::filesystem::path(path).filename();
  bool taken = name.extension() != ".yaml" && name.extension() != ".yml";
  for (const char* own : {"gains.yaml", "study.yaml", "reduced_study.yaml", kOldRunRecord, "verdict.yaml"})
    taken = taken || name == own;
  return (taken ? "ros_" : "") + name.string();
}

bool same_metrics(const RolloutResult& a, const RolloutResult& b) {
  const auto metrics = all_metrics();
  return std::none_of(metrics.begin(), metrics.end(), [&](Metric m) {
    return a.metrics[m] != b.metrics[m] && !(std::isnan(a.metrics[m]) && std::isnan(b.metrics[m]));
  });
}

}  // namespace

std::vector<ComparedSet> simulate_again(const Study& study, const TuneResult& result,
                                        const TuneSettings& settings) {
  const std::atomic<bool> never{false};  // an interrupted search still ends with its files
  const std::string& folder = settings.place.folder;
  SimulateOptions how;
  how.stepper = study.stepper;
  how.workers = settings.workers;
  how.record_stride = settings.record_every;
  how.mcap = settings.mcap;
  how.folder = folder.empty() ? "" : folder + "/start";
  const auto start = [&](const Scenario&) { return study.space.start; };
  std::vector<ComparedSet> sets = {{"start", simulate(study.scenarios, start, how, never)}};
  how.folder = folder;
  const auto best = [&](const Scenario&) { return result.best.gains; };
  sets.push_back({name(outcome_of(result)), simulate(study.scenarios, best, how, never)});
  if (!study.given) return sets;
  how.folder = folder.empty() ? "" : folder + "/given";
  const auto given = [&](const Scenario&) { return *study.given; };
  sets.push_back({"given", simulate(study.scenarios, given, how, never)});
  return sets;
}

std::vector<ComparedSet> simulate_arms_again(const Study& study, const TuneResult& result,
                                             const TuneSettings& settings, RankGroup& ranks) {
  const std::atomic<bool> never{false};
  CandidateRunner fresh(ranks.pool(), study.robust);
  const auto evaluations = simulate_points(study, {result.start.x, result.best.x}, fresh, never, {});
  std::vector<ComparedSet> sets = {{"start", {}}, {name(outcome_of(result)), {}}};
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const Evaluation& seen = i == 0 ? result.start : result.best;
    for (std::size_t s = 0; s < study.scenarios.size(); ++s) {
      const RolloutResult& again = (*evaluations)[i].results[s];
      if (seen.engine == Engine::kSimbody && !same_metrics(again, seen.results[s])) {
        throw FailedError(
            fmt::format("{}: a second simulation of the {} gains gave other metrics than the search",
                        study.scenarios[s].name, sets[i].name));
      }
      sets[i].results.push_back({study.scenarios[s].name, again});
    }
  }
  const std::string& folder = settings.place.folder;
  if (folder.empty()) return sets;
  write_text_file(folder + "/start/robust_errors.csv", errors_csv(sets[0].results));
  write_text_file(folder + "/robust_errors.csv", errors_csv(sets[1].results));
  return sets;
}

void judge(const Objective& objective, const ComparedSet& simulated, TuneResult& result) {
  Evaluation& e = result.best;
  for (std::size_t s = 0; s < simulated.results.size(); ++s) e.results[s] = simulated.results[s].result;
  e.engine = Engine::kSimbody;
  objective.judge(e);
}

void write_gains(const Study& study, const TuneResult& result, const std::string& folder) {
  write_text_file(
      folder + "/gains.yaml",
      gains_yaml(
          result.best.gains,
          {fmt::format("{}, study {}, seed {}", title_of(outcome_of(result)), study.name, study.solver.seed),
           fmt::format("objective {:.6g} (start: 1), largest velocity ratio {:.4f}{}, {}{}",
                       result.best.objective, largest_velocity_ratio(study, result.best), robust_text(study),
                       result.best.feasible ? "feasible" : "NOT feasible",
                       result.best.engine == Engine::kSimbody ? "" : "; not yet simulated in simbody")}));
}

std::string write_controllers(const Study& study, const Gains& gains, const std::string& folder) {
  const std::vector<std::string> joints = joint_names(*study.scenarios.front().robot);
  if (study.gains.empty()) return {};
  const auto file = read_parameter_file(study.gains, study.node, study.distro, joints);
  if (!file || controller_gains(file->controller, file->path, joints).controller != gains.controller)
    return {};
  std::string name = name_beside_results(file->path);
  write_text_file(folder + "/" + name, with_gains(file->text, file->controller, file->path, gains, joints));
  return name;
}

void write_errors(const Study& study, const std::vector<ComparedSet>& sets,
                  const std::vector<YardstickFiles>& yardsticks, const std::string& folder) {
  write_text_file(folder + "/start/errors.csv", errors_csv(sets[0].results, yardsticks[0].errors));
  write_text_file(folder + "/errors.csv", errors_csv(sets[1].results, yardsticks[1].errors));
  if (sets.size() > 2) write_text_file(folder + "/given/errors.csv", errors_csv(sets[2].results));
  std::vector<FileColumns> columns = {{"errors.csv", error_columns(yardsticks[1].errors)},
                                      {"rollout_*.csv", rollout_columns(study.scenarios)},
                                      {"evaluations.csv", evaluation_columns(study)}};
  columns.insert(columns.end(), yardsticks[1].columns.begin(), yardsticks[1].columns.end());
  write_text_file(folder + "/columns.csv", columns_csv(columns));
}

RunRecord record_of_tuning(const Study& study, const TuneResult& result, const Invocation& invocation,
                           int workers, double seconds, const std::string& folder) {
  RunRecord run = record_of_search(study, invocation, workers, seconds);
  run.kind = RunKind::kTune;
  run.search->algorithm = search_text(study);
  run.search->engine = engine_of_search(study);
  run.search->evaluations = result.evaluations;
  run.search->ended = result.ended;
  run.search->reason = result.reason;
  run.tuned = {result.best.feasible, result.best.objective, hash_of_file(folder + "/gains.yaml")};
  if (!std::isfinite(result.best.objective)) run.tuned->objective.reset();
  return run;
}

}  // namespace armtune::internal
