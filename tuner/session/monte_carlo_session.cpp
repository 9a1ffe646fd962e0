#include "tuner/session/monte_carlo_session.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/controller_files/parameter_file.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/arm_distribution.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/robustness/drawn_arm.hpp"
#include "tuner/rollouts/recording_memory.hpp"
#include "tuner/rollouts/simulate.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/write_run_record.hpp"
#include "tuner/session/recorded_distribution.hpp"
#include "tuner/session/report_files.hpp"
#include "tuner/verdict/yield_check.hpp"

namespace armtune::internal {

MonteCarloSession::MonteCarloSession(MonteCarloSettings settings, SessionContext context,
                                     MonteCarloObserver& observer)
    : settings_(std::move(settings)), context_(std::move(context)), observer_(observer) {}

std::optional<MonteCarloOutcome> MonteCarloSession::run(RankGroup& ranks) {
  if (!ranks.begin(plan(), settings_.options.workers)) return std::nullopt;
  const auto pool = ranks.pool();
  if (writes()) begin();
  if (const auto ended = run_ ? run_->finished() : std::nullopt) {
    outcome_.was_finished = true;
    outcome_.ending = *ended;
    return std::move(outcome_);
  }
  if (run_ && run_->resumed()) observer_.resumed(run_->journal().records());
  draw(*pool);
  const auto& samples = outcome_.samples;
  if (!samples.empty() && !context_.stop) {
    outcome_.verdict = yield_verdict(settings_.scenarios, samples, settings_.options);
  }
  if (writes()) write_results(pool->count());
  if (context_.stop) return std::move(outcome_);
  outcome_.ending = outcome_.verdict.passed() ? Ending::kPassed : Ending::kChecksFailed;
  if (run_) run_->complete(outcome_.ending);
  return std::move(outcome_);
}

std::vector<std::string> MonteCarloSession::inputs() const {
  std::vector<std::string> inputs;
  if (!settings_.gains_path.empty()) inputs = files_of_gains(settings_.gains_path);
  add_inputs(settings_.scenarios, inputs);
  add_distribution(settings_.options.perturbation, inputs);
  return inputs;
}

RolloutPlan MonteCarloSession::plan() const {
  RolloutPlan plan = monte_carlo_plan(settings_.scenarios, settings_.options);
  plan.deadline = settings_.deadline;
  if (!settings_.gains_path.empty()) {
    for (const std::string& file : files_of_gains(settings_.gains_path))
      plan.facts.emplace_back("gains", hash_of_input(file));
  }
  return plan;
}

RunHeader MonteCarloSession::header() const {
  const MonteCarloOptions& options = settings_.options;
  std::vector<std::string> files;
  add_inputs(settings_.scenarios, files);
  add_distribution(options.perturbation, files);
  std::string uncertainty;
  for (const PerturbationField& f : perturbation_fields()) {
    uncertainty += fmt::format("{}: {}\n", f.name, options.perturbation.*f.width);
  }
  uncertainty += fmt::format("phases: {}\n", options.perturbation.phases);
  if (options.perturbation.distribution)
    uncertainty += fmt::format("distribution: {}\n", hash_of_input(options.perturbation.distribution->file));
  std::string names;  // the order of the results in a record
  for (const Scenario& scenario : settings_.scenarios) names += scenario.name + '\n';
  std::string limits;
  for (const MetricLimit& limit : options.limits) limits += to_string(limit) + '\n';
  std::vector<std::pair<std::string, std::string>> identity = {
      {"seed", fmt::format("{}", options.seed)},
      {"samples", fmt::format("{}", options.samples)},
      {"scenarios", names},
      {"uncertainty", uncertainty},
      {"limits", limits},
      {"stepper", name(options.stepper)},
      {"gains", gains_yaml(settings_.gains, {})}};
  if (options.engine != Engine::kSimbody) identity.emplace_back("engine", name(options.engine));
  return run_header(context_.invocation, std::move(identity), files);
}

void MonteCarloSession::begin() {
  const RunHeader begun = header();
  require_recording_memory(settings_.scenarios, SimulateOptions().record_stride, settings_.options.workers);
  run_.emplace(settings_.place, begun, inputs(), observer_);
  run_->keep();
}

/// Writes every complete sample to the journal, and to samples.csv as soon as all before it are complete.
void MonteCarloSession::keep_samples() {
  MonteCarloOptions& options = settings_.options;
  rows_.emplace(folder() + "/samples.csv", AppendFile::Open::kReplace);
  rows_->append(samples_header(settings_.scenarios, options), false);
  options.known = [this](std::uint64_t number) {
    auto record = run_->journal().find(number);
    return record ? std::optional(std::move(record->results)) : std::nullopt;
  };
  options.finished = [this](const MonteCarloSample& sample) {
    rows_->append(sample_rows(settings_.scenarios, settings_.options, sample), false);
  };
  options.whole = [this](const MonteCarloSample& sample) {
    run_->journal().append({sample.number, "sample", run_->seconds(), {}, sample.results});
    rows_->publish();
  };
}

void MonteCarloSession::draw(RolloutPool& pool) {
  MonteCarloOptions& options = settings_.options;
  options.progress = [this](std::size_t done, std::size_t all) {
    const double left = watch_.seconds() / static_cast<double>(done) * static_cast<double>(all - done);
    observer_.progressed({"rollouts", static_cast<long>(done), static_cast<long>(all), left});
  };
  if (writes()) keep_samples();
  auto& samples = outcome_.samples;
  try {
    samples = monte_carlo(pool, settings_.gains, options, context_.stop);
  } catch (...) {
    if (run_ && run_->can_resume()) observer_.can_resume(folder());
    throw;
  }
  // After an interruption, keeps the samples before the first gap, as samples.csv does.
  const auto gap =
      std::find_if(samples.begin(), samples.end(),
                   [next = options.first](const MonteCarloSample& s) mutable { return s.number != next++; });
  samples.erase(gap, samples.end());
  observer_.part_is_over();
  if (!rows_) return;
  rows_->publish();
  rows_->sync();
}

void MonteCarloSession::write_results(int workers) {
  const MonteCarloOptions& options = settings_.options;
  write_text_file(folder() + "/summary.csv", summary_csv(settings_.scenarios, outcome_.samples));
  RunRecord record;
  record.kind = RunKind::kRobustness;
  record.command = context_.invocation.line;
  record.wall_seconds = run_->seconds();
  record.seed = options.seed;
  record.workers = workers;
  record.robustness = {static_cast<long>(outcome_.samples.size()), options.stepper, options.engine, {}};
  for (const MetricLimit& limit : options.limits)
    record.robustness->limits.push_back({name(limit.metric), limit.upper, limit.value});
  record.distribution = distribution_facts(options.perturbation);
  write_run_record(folder(), std::move(record), {inputs()});
  outcome_.files = {"samples.csv", "summary.csv", kRunRecord, "inputs/"};
  if (settings_.writes_arm && outcome_.samples.size() == 1) write_arm();
  if (!outcome_.verdict.checks.empty()) {
    write_verdict(folder(), outcome_.verdict);
    outcome_.files.emplace_back("verdict.yaml");
  }
  outcome_.recorded = !context_.stop;
  const auto pages = add_report(
      folder(), [this] { return scene(); }, observer_);
  outcome_.files.insert(outcome_.files.end(), pages.begin(), pages.end());
}

/// Writes the only random arm as files that other programs can read.
void MonteCarloSession::write_arm() {
  const MonteCarloOptions& options = settings_.options;
  const Scenario drawn =
      perturbed(settings_.scenarios.front(), options.perturbation, options.seed, options.first);
  for (const auto& [name, text] : drawn_arm_files(drawn)) {
    write_text_file(folder() + "/" + name, text);
    outcome_.files.push_back(name);
  }
}

/// Returns the scene of the report, which shows the nominal arm.
report::Scene MonteCarloSession::scene() const {
  const std::string label = settings_.gains_path.empty() ? "gains" : stem(settings_.gains_path);
  report::SceneSet nominal = {label, "nominal", "nominal/errors.csv"};
  if (outcome_.recorded) {
    nominal = record_set(label, folder(), "nominal", settings_.scenarios, settings_.gains,
                         {settings_.options.stepper, settings_.options.workers});
  }
  return report::scene_of(settings_.scenarios, {nominal}, settings_.gains.obstacleInfluenceRadius);
}

}  // namespace armtune::internal
