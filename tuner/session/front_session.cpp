#include "tuner/session/front_session.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "armtune/error.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/rollouts/recording_memory.hpp"
#include "tuner/rollouts/simulate.hpp"
#include "tuner/session/report_files.hpp"
#include "tuner/session/study_files.hpp"
#include "tuner/trade_off/pareto_file.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kLevelsForTwo = 12;
constexpr std::size_t kLevelsForThree = 4;

/// Returns a column for each criterion that is a metric, because the study itself may not use this metric.
std::vector<ExtraColumn> criteria_columns(const Study& study, const ParetoOptions& options) {
  std::vector<ExtraColumn> columns;
  for (const Criterion& c : options.criteria) {
    if (!c.metric) continue;
    columns.push_back({{"criterion/" + c.name(),
                        c.unit(),
                        fmt::format("{}; worst value of all scenarios", field(*c.metric).meaning),
                        {}},
                       [c, &study](const Evaluation& e) { return value(c, e, study.scenarios); }});
  }
  return columns;
}

}  // namespace

FrontSession::FrontSession(Study study, FrontSettings settings, SessionContext context,
                           FrontObserver& observer)
    : study_(std::move(study)),
      settings_(std::move(settings)),
      context_(std::move(context)),
      observer_(observer) {}

std::optional<FrontOutcome> FrontSession::run(RankGroup& ranks) {
  if (!ranks.begin(plan_of(study_, settings_.deadline), settings_.workers)) return std::nullopt;
  outcome_.options = options();
  if (writes()) {
    const RunHeader begun = header();
    require_recording_memory(study_.scenarios, SimulateOptions().record_stride, settings_.workers);
    run_.emplace(settings_.place, begun, files_of(study_), observer_);
  }
  if (const auto ended = run_ ? run_->finished() : std::nullopt) {
    outcome_.was_finished = true;
    outcome_.ending = *ended;
    return std::move(outcome_);
  }
  warn_of_given(study_, observer_);
  warn_of_clamped(study_, observer_);
  CandidateRunner workers(ranks.pool(), study_.robust);
  try {
    search(ranks, workers);
  } catch (...) {
    if (run_ && objective_ && run_->can_resume()) observer_.can_resume(folder());
    throw;
  }
  if (outcome_.result.evaluations == 0) {
    run_.reset();
    return std::move(outcome_);
  }
  if (writes()) write_reports(workers.count());
  outcome_.seconds = watch_.seconds();
  if (!outcome_.verified) return std::move(outcome_);
  outcome_.ending = outcome_.result.front.empty() ? Ending::kChecksFailed : Ending::kPassed;
  if (run_) run_->complete(outcome_.ending);
  return std::move(outcome_);
}

ParetoOptions FrontSession::options() const {
  constexpr std::size_t kLeast = 2, kMost = 3;
  if (settings_.criteria.size() < kLeast || settings_.criteria.size() > kMost) {
    throw InputError(InputPlace{.key = "criteria"},
                     fmt::format("{} are given; give two or three", settings_.criteria.size()))
        .with_value(std::to_string(settings_.criteria.size()), "two or three");
  }
  if (settings_.levels == 1)
    throw InputError(InputPlace{.key = "levels"}, "1 is given; give at least 2")
        .with_value("1", "at least 2");
  ParetoOptions options;
  for (const std::string& name : settings_.criteria) {
    options.criteria.push_back(criterion_from_name(name));
    for (std::size_t k = 0; k + 1 < options.criteria.size(); ++k) {
      if (options.criteria[k].name() == name) throw InputError("criterion " + name + " is given twice");
    }
  }
  options.levels = settings_.levels > 0           ? settings_.levels
                   : options.criteria.size() == 2 ? kLevelsForTwo
                                                  : kLevelsForThree;
  options.max_evaluations =
      settings_.max_evaluations > 0 ? settings_.max_evaluations : 4 * study_.max_evaluations;
  const auto least = static_cast<long>(options.searches() * (study_.space.free.size() + 1));
  if (options.max_evaluations < 3 * least / 2) {
    observer_.warned(fmt::format(
        "{} evaluations are too few for {} searches over {} gains, because each search starts with one "
        "evaluation per gain; allow {} evaluations, or use fewer --levels",
        options.max_evaluations, options.searches(), study_.space.free.size(), 3 * least / 2));
  }
  return options;
}

RunHeader FrontSession::header() const {
  auto identity = identity_of(study_);
  identity.emplace_back("criteria", fmt::format("{}", fmt::join(settings_.criteria, " ")));
  identity.emplace_back("levels", fmt::format("{}", outcome_.options.levels));
  identity.emplace_back("max_evaluations", fmt::format("{}", outcome_.options.max_evaluations));
  return run_header(context_.invocation, std::move(identity), inputs_of(study_));
}

ParetoCallbacks FrontSession::callbacks() {
  ParetoCallbacks callbacks;
  callbacks.begin = [this](const Objective& objective) {
    objective_ = objective;
    if (run_) run_->keep();
    observer_.began(study_, outcome_.options, run_ ? run_->journal().records() : 0);
    if (!writes()) return;
    write_start(study_, folder());
    write_scene(folder(), scene(false));
    evaluations_.emplace(folder() + "/evaluations.csv", study_, criteria_columns(study_, outcome_.options),
                         AppendFile::Open::kReplace);
  };
  callbacks.evaluated = [this](const char* phase, const Evaluation& e) {
    if (evaluations_) evaluations_->append(phase, e);
    last_seconds_ = e.seconds;
  };
  callbacks.progress = [this](const ParetoProgress& p) {
    observer_.progressed({p.phase, p.evaluations, p.max_evaluations,
                          seconds_left(p.evaluations, p.max_evaluations, last_seconds_, study_.max_minutes),
                          fmt::format("{} points", p.front)});
  };
  return callbacks;
}

void FrontSession::search(RankGroup& ranks, CandidateRunner& workers) {
  ParetoResult& result = outcome_.result;
  result = pareto(study_, outcome_.options, workers, context_.stop, callbacks(),
                  run_ ? &run_->journal() : nullptr);
  if (evaluations_) evaluations_->finish();
  observer_.part_is_over();
  // The front is first written as the search found it, so that it is not lost if a later step fails.
  if (writes() && !result.front.empty()) write_front();
  if (result.failure) std::rethrow_exception(result.failure);
  if (result.evaluations > 0 && !result.interrupted) {
    observer_.progressed({fmt::format("simulating the {} points of the front again", result.front.size())});
    CandidateRunner fresh(ranks.pool(), study_.robust);
    outcome_.verified = verify(study_, *objective_, outcome_.options, result, fresh, context_.stop);
    observer_.part_is_over();
  }
  if (writes() && result.evaluations > 0) write_front();
}

void FrontSession::write_front() const {
  const ParetoResult& result = outcome_.result;
  write_text_file(folder() + "/pareto.csv", pareto_csv(study_, outcome_.options, result));
  make_folder(folder() + "/points");
  for (std::size_t i = 0; i < result.front.size(); ++i) {
    const ParetoPoint& p = result.front[i];
    std::vector<std::string> header = {
        fmt::format("point {} of the trade-off front of study {}, found by armtune with seed {}", i + 1,
                    study_.name, study_.solver.seed)};
    for (const Criterion& c : outcome_.options.criteria) {
      header.push_back(fmt::format("{} {:.6g} (start {:.6g})", c.name(), value(c, p.e, study_.scenarios),
                                   value(c, result.start.e, study_.scenarios)));
    }
    write_text_file(folder() + "/" + point_file(i), gains_yaml(p.e.gains, header));
  }
  // Removes the points of a longer front that was written before.
  for (std::size_t i = result.front.size(); std::filesystem::remove(folder() + "/" + point_file(i)); ++i) {
  }
}

/// Returns the scene of the report: the start, and the point with the best first criterion.
report::Scene FrontSession::scene(bool recorded) const {
  std::vector<report::SceneSet> sets = {{"start", "start", "start/errors.csv"}};
  if (recorded) {
    const RecordOptions how = {study_.stepper, settings_.workers};
    sets = {record_set("start", folder(), "start", study_.scenarios, study_.space.start, how)};
    if (!outcome_.result.front.empty()) {
      sets.push_back(record_set("point 1", folder(), "shown", study_.scenarios,
                                outcome_.result.front.front().e.gains, how));
      sets.back().point = 1;
    }
  }
  return report::scene_of(study_.scenarios, std::move(sets), study_.space.start.obstacleInfluenceRadius);
}

void FrontSession::write_reports(int workers) {
  const ParetoResult& result = outcome_.result;
  const auto criteria = criteria_columns(study_, outcome_.options);
  write_text_file(folder() + "/columns.csv",
                  columns_csv({{"pareto.csv", pareto_columns(study_, outcome_.options)},
                               {"evaluations.csv", evaluation_columns(study_, criteria)}}));
  RunRecord record = record_of_search(study_, context_.invocation, workers, run_->seconds());
  record.kind = RunKind::kPareto;
  record.search->engine = study_.engine;
  record.search->evaluations = result.evaluations;
  record.search->ended = result.interrupted   ? SearchEnd::kInterrupted
                         : result.out_of_time ? SearchEnd::kTime
                                              : SearchEnd::kLevelsSearched;
  record.front = {settings_.criteria, static_cast<long>(result.front.size()), outcome_.verified,
                  result.hypervolume};
  write_run_record(folder(), std::move(record), {files_of(study_)});
  outcome_.files = {"pareto.csv", "points/", "evaluations.csv", "columns.csv", "study.yaml", kRunRecord};
  const auto pages = add_report(
      folder(), [this] { return scene(outcome_.verified); }, observer_);
  outcome_.files.insert(outcome_.files.end(), pages.begin(), pages.end());
}

}  // namespace armtune::internal
