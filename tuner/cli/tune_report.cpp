#include "tuner/cli/tune_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/csv/text_file.hpp"
#include "sim/rollout/columns.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/warm_arguments.hpp"
#include "tuner/evaluation/evaluations_file.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/rollouts/simulate.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/search/last_steps.hpp"
#include "tuner/verdict/search_checks.hpp"

namespace armtune::cli {

namespace {

/// Returns the first words of a gains file, which say what its gains are.
const char* title_of(SearchOutcome outcome) {
  switch (outcome) {
    case SearchOutcome::kTuned:
      return "tuned by armtune";
    case SearchOutcome::kStart:
      return "start gains: armtune found nothing better";
    case SearchOutcome::kLeastViolation:
      return "NOT feasible: the point with the least violation that armtune found";
  }
  return "";
}

}  // namespace

std::string search_text(const Study& study) {
  return fmt::format("{}{}{}", global_of(study).empty() ? "" : global_of(study) + ", then ",
                     study.solver.algorithm,
                     study.starts > 1 ? fmt::format(" from {} starts", study.starts) : "");
}

std::string engine_text(const Study& study) {
  const Engine engine = engine_of_search(study);
  return engine == Engine::kSimbody ? "simbody" : fmt::format("{}, then simbody", name(engine));
}

std::string budget_text(long max_evaluations, double max_minutes) {
  return fmt::format("{} evaluations{}", max_evaluations,
                     max_minutes > 0.0 ? fmt::format(" or {} minutes", max_minutes) : "");
}

double seconds_left(long evaluations, long max_evaluations, double seconds, double max_minutes) {
  const double by_evaluations =
      seconds / static_cast<double>(evaluations) * static_cast<double>(max_evaluations - evaluations);
  if (max_minutes <= 0.0) return by_evaluations;
  return std::min(by_evaluations, std::max(0.0, 60.0 * max_minutes - seconds));
}

std::string robust_text(const Study& study) {
  if (!study.robust) return {};
  return fmt::format(" ({} of {} arms each)",
                     risk_measure_names()[static_cast<std::size_t>(study.robust->measure)],
                     arms(*study.robust));
}

std::vector<std::string> files_of(const Study& study) {
  std::vector<std::string> files = {study.source, study.gains};
  if (study.warm) files.push_back(study.warm->source);
  add_inputs(study.scenarios, files);
  return files;
}

Provenance study_provenance(const Study& study, int workers, double seconds,
                            const std::vector<std::pair<std::string, std::string>>& found) {
  Provenance p;
  p.command = command_line();
  p.inputs = files_of(study);
  p.seed = study.solver.seed;
  p.workers = workers;
  p.wall_seconds = seconds;
  p.extra = {{"study", shown_path(study.source)}, {"start", stem(study.gains)}};
  p.extra.insert(p.extra.end(), found.begin(), found.end());
  return p;
}

std::vector<ComparedSet> verify(const Study& study, const TuneResult& result, const ReportOptions& options) {
  const std::atomic<bool> never{false};  // an interrupted search still ends with its files
  SimulateOptions how;
  how.stepper = study.stepper;
  how.workers = options.workers;
  how.record_stride = options.record_every;
  how.folder = options.folder + "/start";
  std::vector<ComparedSet> sets(2);
  sets[0] = {"start", simulate(
                          study.scenarios, [&](const Scenario&) { return study.space.start; }, how, never)};
  how.folder = options.folder;
  sets[1] = {name(outcome_of(result)),
             simulate(
                 study.scenarios, [&](const Scenario&) { return result.best.gains; }, how, never)};
  return sets;
}

std::vector<ComparedSet> verify_robust(const Study& study, const TuneResult& result,
                                       const ReportOptions& options, RankGroup& team) {
  const std::atomic<bool> never{false};
  CandidateRunner fresh(team.pool(), study.robust);
  const auto evaluations = simulate_points(study, {result.start.x, result.best.x}, fresh, never, {});
  std::vector<ComparedSet> sets = {{"start", {}}, {name(outcome_of(result)), {}}};
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const Evaluation& seen = i == 0 ? result.start : result.best;
    for (std::size_t s = 0; s < study.scenarios.size(); ++s) {
      const RolloutResult& again = (*evaluations)[i].results[s];
      const auto differs = [&](Metric m) {
        const double a = again.metrics[m];
        const double b = seen.results[s].metrics[m];
        return a != b && !(std::isnan(a) && std::isnan(b));
      };
      const auto metrics = all_metrics();
      if (seen.engine == Engine::kSimbody && std::any_of(metrics.begin(), metrics.end(), differs)) {
        throw std::runtime_error(fmt::format("{}: the {} gains simulated again give other figures",
                                             study.scenarios[s].name, sets[i].name));
      }
      sets[i].results.push_back({study.scenarios[s].name, again});
    }
  }
  write_text_file(options.folder + "/start/robust_errors.csv", errors_csv(sets[0].results));
  write_text_file(options.folder + "/robust_errors.csv", errors_csv(sets[1].results));
  return sets;
}

void judge(const Objective& objective, const ComparedSet& simulated, TuneResult& result) {
  Evaluation& e = result.best;
  for (std::size_t s = 0; s < simulated.results.size(); ++s) e.results[s] = simulated.results[s].result;
  e.engine = Engine::kSimbody;
  objective.judge(e);
}

void write_start(const Study& study, const std::string& folder) {
  make_folder(folder + "/start");
  write_text_file(folder + "/start/gains.yaml",
                  gains_yaml(study.space.start, {"start of " + shown_path(study.source)}));
  write_text_file(folder + "/study.yaml", study_yaml(study, "start/gains.yaml", write_warm(study, folder)));
}

void write_gains(const Study& study, const TuneResult& result, const std::string& folder) {
  write_text_file(
      folder + "/gains.yaml",
      gains_yaml(
          result.best.gains,
          {fmt::format("{}, study {}, seed {}", title_of(outcome_of(result)), study.name, study.solver.seed),
           fmt::format("objective {:.6g} of the start's 1, largest velocity ratio {:.4f}{}, {}{}",
                       result.best.objective, largest_velocity_ratio(study, result.best), robust_text(study),
                       result.best.feasible ? "feasible" : "NOT feasible",
                       result.best.engine == Engine::kSimbody ? "" : "; not yet judged by simbody")}));
}

std::vector<YardstickFiles> measure_sets(const Study& study, const TuneResult& result,
                                         const std::string& folder) {
  std::vector<YardstickFiles> files(2);
  files[0] =
      write_yardstick(folder + "/start", study.scenarios, [&](const Scenario&) { return study.space.start; });
  if (!stop_requested()) {
    files[1] = write_yardstick(folder, study.scenarios, [&](const Scenario&) { return result.best.gains; });
  }
  return files;
}

void write_reports(const Study& study, const TuneResult& result, const std::vector<ComparedSet>& sets,
                   const std::vector<YardstickFiles>& yardsticks, const ReportOptions& options, int workers,
                   double seconds) {
  const std::string& folder = options.folder;
  write_text_file(folder + "/start/errors.csv", errors_csv(sets[0].results, yardsticks[0].errors));
  write_text_file(folder + "/errors.csv", errors_csv(sets[1].results, yardsticks[1].errors));
  std::vector<FileColumns> columns = {{"errors.csv", error_columns(yardsticks[1].errors)},
                                      {"rollout_*.csv", rollout_columns(study.scenarios)},
                                      {"evaluations.csv", evaluation_columns(study)}};
  columns.insert(columns.end(), yardsticks[1].columns.begin(), yardsticks[1].columns.end());
  write_text_file(folder + "/columns.csv", columns_csv(columns));
  const Provenance p = study_provenance(study, workers, seconds,
                                        {{"evaluations", fmt::format("{}", result.evaluations)},
                                         {"algorithm", search_text(study)},
                                         {"stepper", name(study.stepper)},
                                         {"engine", engine_text(study)},
                                         {"ended", result.reason},
                                         {"feasible", result.best.feasible ? "true" : "false"},
                                         {"objective", fmt::format("{}", result.best.objective)},
                                         {"gains_file", hash_of_file(folder + "/gains.yaml")}});
  write_provenance(folder, p);
}

void print_gains(const Study& study, const TuneResult& result) {
  const Gains& gains = result.best.gains;
  const std::string found = name(outcome_of(result));
  say(fmt::format("{:<44}{:>12}{:>17}{:>11}\n", "gain", "start", found, "ratio"));
  for (const Parameter& p : study.space.free) {
    const double tuned = value(gains, p.entry);
    say(fmt::format("{:<44}{:>12.5g}{:>17.5g}{:>11}{}\n", p.entry.name, p.start, tuned,
                    p.start > 0.0 ? fmt::format("{:.3f}", tuned / p.start) : "-",
                    on_bound(p, tuned) ? "  at its bound" : ""));
  }
  say(fmt::format("\n"));
}

void print_search(const Study& study, const TuneResult& result, const Objective& objective) {
  say(fmt::format("{}: objective {:.4f} (start 1{}) after {} evaluations; {}\n", study.name,
                  result.best.objective,
                  result.best_of_sweep
                      ? fmt::format(", best of the coarse sweep {:.4f}{}", result.best_of_sweep->objective,
                                    result.best_of_sweep->feasible ? "" : ", not feasible")
                      : "",
                  result.evaluations, result.reason));
  say(fmt::format("largest velocity ratio {:.4f}{}; {}\n", largest_velocity_ratio(study, result.best),
                  robust_text(study), result.best.feasible ? "every constraint holds" : "NOT feasible:"));
  if (result.best.feasible) return;
  if (result.best.status != "completed") say(fmt::format("  {}\n", result.best.status));
  for (std::size_t c = 0; c < objective.constraints().size(); ++c) {
    if (result.best.constraints[c] > 0.0) {
      say(fmt::format("  {} is missed by {:.4g}\n", objective.constraint_name(c),
                      result.best.constraints[c]));
    }
  }
}

}  // namespace armtune::cli
