#include "tuner/session/sensitivity_session.hpp"

#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/write_run_record.hpp"
#include "tuner/session/study_files.hpp"

namespace armtune::internal {

SensitivitySession::SensitivitySession(SensitivitySettings settings, SessionContext context,
                                       SessionObserver& observer)
    : settings_(std::move(settings)), context_(std::move(context)), observer_(observer) {}

std::string SensitivitySession::gains_path() const {
  return run_file(settings_.run, "gains.yaml");
}

std::optional<SensitivityOutcome> SensitivitySession::run(RankGroup& ranks) {
  const Study& study = settings_.study;
  if (!ranks.begin(plan_of(study, settings_.deadline), settings_.workers)) return std::nullopt;
  const Gains best = load_gains(gains_path(), joint_names(*study.scenarios.front().robot));
  const HashedTable evaluations = read_hashed_table(run_file(settings_.run, "evaluations.csv"));
  const auto journal = read_evaluations(evaluations.table, study);
  const FolderLock lock = make_run_folder(settings_.folder);

  CandidateRunner workers(ranks.pool(), study.robust);
  std::optional<Sensitivity> result;
  if (const auto start = simulate_points(study, {study.space.start_point()}, workers, context_.stop)) {
    const Objective objective(study.terms, study.constraints, simulated_scenarios(study),
                              start->front().results, study.source);
    result = sensitivity(study, objective, best, journal, workers, context_.stop,
                         progress_of(observer_, "evaluations"));
  }
  observer_.part_is_over();
  if (!result) return std::move(outcome_);
  outcome_.sensitivity = std::move(*result);
  if (!settings_.folder.empty()) write_files(evaluations, workers.count());
  outcome_.ending = Ending::kPassed;
  return std::move(outcome_);
}

void SensitivitySession::write_files(const HashedTable& evaluations, int workers) {
  const Study& study = settings_.study;
  const std::string& folder = settings_.folder;
  make_folder(folder + "/start");
  write_text_file(folder + "/start/gains.yaml",
                  gains_yaml(study.space.start, {"start of " + shown_path(study.source)}));
  write_sensitivity(study, outcome_.sensitivity, folder);
  RunRecord record;
  record.kind = RunKind::kSensitivity;
  record.command = context_.invocation.line;
  record.wall_seconds = watch_.seconds();
  record.seed = study.solver.seed;
  record.workers = workers;
  FilesRead files{files_of(study), {{evaluations.table.name(), evaluations.hash}}};
  files.inputs.push_back(gains_path());
  write_run_record(folder, std::move(record), files);
  outcome_.files = {"sensitivity.csv", "reduced_study.yaml", kRunRecord, "inputs/"};
}

}  // namespace armtune::internal
