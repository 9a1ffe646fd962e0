#include "tuner/session/tune_session.hpp"

#include <fmt/format.h>

#include <exception>

#include "armtune/error.hpp"
#include "sim/csv/text_file.hpp"
#include "tuner/evaluation/evaluations_file.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/rollouts/recording_memory.hpp"
#include "tuner/search/last_steps.hpp"
#include "tuner/session/live_report.hpp"
#include "tuner/session/report_files.hpp"
#include "tuner/session/study_files.hpp"
#include "tuner/session/task_notes.hpp"
#include "tuner/session/tune_files.hpp"
#include "tuner/verdict/search_checks.hpp"

namespace armtune::internal {

TuneSession::TuneSession(Study study, TuneSettings settings, SessionContext context, TuneObserver& observer)
    : study_(std::move(study)),
      settings_(std::move(settings)),
      context_(std::move(context)),
      observer_(observer) {}

std::optional<TuneOutcome> TuneSession::run(RankGroup& ranks) {
  if (!ranks.begin(plan_of(study_, settings_.deadline), settings_.workers)) return std::nullopt;
  if (writes()) begin();
  if (const auto ended = run_ ? run_->finished() : std::nullopt) {
    outcome_.was_finished = true;
    outcome_.ending = *ended;
    return std::move(outcome_);
  }
  warn_of_given(study_, observer_);
  warn_of_clamped(study_, observer_);
  warn_of_doubts(study_.scenarios, observer_);
  // Warns before the start gains are simulated. If no gains can do the task, this explains their failure.
  for (const Scenario& scenario : study_.scenarios) {
    for (const std::string& warning : warn_of_task(scenario, study_.space.start, observer_))
      task_warnings_.push_back(warning);
  }
  CandidateRunner workers(ranks.pool(), study_.robust);
  count_ = workers.count();
  search(workers);
  const TuneResult& result = outcome_.result;
  // A launcher of ranks that passes on a signal kills the ranks soon after.
  if (result.evaluations == 0 || (result.interrupted && ranks.several())) {
    run_.reset();
    return std::move(outcome_);
  }
  verify(ranks);
  observer_.verified(outcome_);
  const bool analysed = settings_.analysis && !result.interrupted && analyse(workers);
  observer_.searched(outcome_);
  check(analysed);
  conclude(analysed);
  return std::move(outcome_);
}

void TuneSession::begin() {
  require_recording_memory(study_.scenarios, settings_.record_every, settings_.workers);
  run_.emplace(settings_.place, run_header(context_.invocation, identity_of(study_), inputs_of(study_)),
               files_of(study_), observer_,
               [this] { write_warm(study_, folder()); });  // a resumed run reads them here
}

void TuneSession::search(CandidateRunner& workers) {
  try {
    outcome_.result = search_with_files(workers);
  } catch (...) {
    if (run_ && outcome_.objective && run_->can_resume()) observer_.can_resume(folder());
    throw;
  }
  observer_.part_is_over();
  if (writes() && outcome_.result.evaluations > 0) write_gains(study_, outcome_.result, folder());
}

/// Runs the search. Every evaluation is on disk before the search continues.
TuneResult TuneSession::search_with_files(CandidateRunner& workers) {
  std::optional<EvaluationsFile> file;
  std::optional<LiveReport> live;
  if (settings_.live && writes()) live.emplace(folder(), observer_);
  TuneResult so_far;  // kept here, so that nothing finished is lost if the disk or a rollout fails
  TuneCallbacks callbacks;
  callbacks.begin = [&](const Objective& objective) {
    outcome_.objective = objective;
    if (run_) run_->keep();
    observer_.began(study_, run_ ? run_->journal().records() : 0);
    if (!writes()) return;
    write_start(study_, folder());
    write_scene(folder(), report::scene_of(study_.scenarios, report::usual_sets(RunKind::kTune, folder()),
                                           study_.space.start.obstacleInfluenceRadius));
    file.emplace(folder() + "/evaluations.csv", study_, std::vector<ExtraColumn>(),
                 AppendFile::Open::kReplace);
  };
  if (settings_.analysis) callbacks.fault = [this](const Gains& gains) { return fault_of(gains); };
  callbacks.evaluated = [&](const char* phase, const Evaluation& e) {
    if (so_far.evaluations++ == 0 || better(e, so_far.best)) so_far.best = e;
    evaluations_.push_back({study_.space.point_of(e.gains), e.objective, e.violation});
    if (file) file->append(phase, e);
    observer_.evaluated(e);
  };
  callbacks.progress = [&](const TuneProgress& p) {
    const double left = seconds_left(p.evaluations, p.max_evaluations, p.last->seconds, study_.max_minutes);
    if (live) live->update(p.evaluations, p.max_evaluations, left);
    observer_.progressed(
        {p.phase, p.evaluations, p.max_evaluations, left,
         fmt::format("best {:.4f}{}, velocity ratio {:.3f}, {:.2f} rollouts/s", p.best->objective,
                     p.best->feasible ? "" : " (infeasible)", largest_velocity_ratio(study_, *p.best),
                     static_cast<double>(workers.rollouts_done()) / watch_.seconds())});
  };
  try {
    TuneResult result = tune(study_, workers, context_.stop, callbacks, run_ ? &run_->journal() : nullptr);
    if (file) file->finish();
    return result;
  } catch (...) {
    const auto failure = std::current_exception();
    try {
      if (file && so_far.evaluations > 0) write_gains(study_, so_far, folder());
    } catch (const std::exception&) {  // the first failure is the one to report
    }
    std::rethrow_exception(failure);
  }
}

/// Simulates the start gains and the resulting gains again, for the reported figures and the recordings.
void TuneSession::verify(RankGroup& ranks) {
  TuneResult& result = outcome_.result;
  observer_.progressed({"simulating the start gains and the tuned gains again"});
  outcome_.sets = simulate_again(study_, result, settings_);
  observer_.part_is_over();
  if (study_.robust) outcome_.robust = simulate_arms_again(study_, result, settings_, ranks);
  if (result.best.engine != Engine::kSimbody) {
    judge(*outcome_.objective, study_.robust ? outcome_.robust[1] : outcome_.sets[1], result);
    if (writes()) write_gains(study_, result, folder());
  }
  if (!writes()) return;
  write_reports();  // first without the yardsticks, which take longer
  if (!settings_.yardstick || result.interrupted) return;
  yardsticks_[0] = settings_.yardstick(folder() + "/start", study_.scenarios,
                                       [this](const Scenario&) { return study_.space.start; });
  if (!context_.stop) {
    yardsticks_[1] = settings_.yardstick(folder(), study_.scenarios,
                                         [&result](const Scenario&) { return result.best.gains; });
  }
  write_reports();
}

/// Writes errors.csv of every gain set, columns.csv and run.json.
void TuneSession::write_reports() {
  write_errors(study_, outcome_.sets, yardsticks_, folder());
  write_run_record(
      folder(),
      record_of_tuning(study_, outcome_.result, context_.invocation, count_, run_->seconds(), folder()),
      {files_of(study_)});
}

bool TuneSession::analyse(CandidateRunner& workers) {
  const Gains& best = outcome_.result.best.gains;
  std::vector<ComparedMargins> sets = {{"start", {}}, {name(outcome_of(outcome_.result)), {}}};
  for (ComparedMargins& set : sets) {
    const bool start = &set == &sets.front();
    MarginOptions options;
    options.stepper = study_.stepper;
    options.engine = engine_of_search(study_);
    options.workers = settings_.workers;
    options.progress = progress_of(observer_, fmt::format("margins of the {} gains", set.name));
    set.margins = margins(study_.scenarios, start ? study_.space.start : best, options, context_.stop);
    observer_.part_is_over();
    if (context_.stop) return false;
    if (!writes()) continue;
    write_text_file(folder() + (start ? "/start/margins.csv" : "/margins.csv"),
                    margins_csv(study_.scenarios, set.margins));
  }
  observer_.found_margins(sets);
  outcome_.sensitivity = sensitivity(study_, *outcome_.objective, best, evaluations_, workers, context_.stop,
                                     progress_of(observer_, "sensitivity"));
  observer_.part_is_over();
  if (!outcome_.sensitivity) return false;
  if (writes()) write_sensitivity(study_, *outcome_.sensitivity, folder());
  observer_.found_sensitivity(*outcome_.sensitivity);
  return true;
}

/// Writes the ROS parameter file with the resulting gains, for gains that passed every check. If that fails,
/// only warns.
void TuneSession::write_controllers_if_any() {
  try {
    outcome_.controllers = write_controllers(study_, outcome_.result.best.gains, folder());
  } catch (const InputError& e) {
    observer_.warned(
        fmt::format("the tuned gains are in gains.yaml, but not in a ROS parameter file: {}", e.what()));
  }
  if (!outcome_.controllers.empty()) outcome_.files.push_back(outcome_.controllers);
}

void TuneSession::conclude(bool analysed) {
  const TuneResult& result = outcome_.result;
  const bool interrupted = result.interrupted || context_.stop;  // then some checks are missing
  if (writes()) {
    if (!interrupted) write_verdict(folder(), outcome_.verdict);
    auto& files = outcome_.files;
    const auto add = [&files](const std::vector<std::string>& more) {
      files.insert(files.end(), more.begin(), more.end());
    };
    add({"gains.yaml", "errors.csv", "rollout_<scenario>.csv", "evaluations.csv", "columns.csv", "study.yaml",
         kRunRecord});
    if (settings_.mcap) add({"rollout_<scenario>.mcap"});
    if (study_.given) add({"given/"});
    if (!interrupted && analysed && outcome_.verdict.passed()) write_controllers_if_any();
    if (!interrupted) add({"verdict.yaml"});
    if (analysed) add({"margins.csv", "sensitivity.csv", "reduced_study.yaml"});
    add(yardsticks_.back().written);
    add(add_report(
        folder(),
        [this, &result] {
          auto sets = report::usual_sets(RunKind::kTune, folder());
          sets.back().name = name(outcome_of(result));
          return report::scene_of(study_.scenarios, std::move(sets),
                                  study_.space.start.obstacleInfluenceRadius);
        },
        observer_));
  }
  outcome_.seconds = watch_.seconds();
  if (interrupted) return;
  outcome_.ending = outcome_.verdict.passed() ? Ending::kPassed : Ending::kChecksFailed;
  if (run_) run_->complete(outcome_.ending);
}

}  // namespace armtune::internal
