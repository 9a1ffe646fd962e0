#include "tuner/session/simulate_session.hpp"

#include "sim/controller_files/parameter_file.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/rollout/recorder.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/rollouts/recording_memory.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/write_run_record.hpp"
#include "tuner/session/report_files.hpp"
#include "tuner/session/task_notes.hpp"
#include "tuner/verdict/assumptions.hpp"
#include "tuner/verdict/rollout_checks.hpp"

namespace armtune::internal {

bool check_rollouts(const RolloutSettings& settings, const std::vector<ScenarioResult>& results,
                    const std::optional<std::vector<EnduranceResult>>& endured, const std::string& set,
                    SimulationVerdict& verdict) {
  add_rollout_checks(results, set, verdict);
  add_contact_checks(settings.scenarios, results, set, verdict);
  if (!endured || endured->size() < settings.scenarios.size()) return false;
  add_endurance_checks(*endured, VerdictThresholds(), set, verdict);
  return true;
}

SimulateOptions simulate_options(const RolloutSettings& settings, const std::string& folder,
                                 const std::string& set, SessionObserver& observer) {
  SimulateOptions options;
  options.stepper = settings.stepper;
  options.engine = settings.engine;
  options.workers = settings.workers;
  options.folder = folder;
  options.record_stride = settings.record_every;
  options.mcap = settings.mcap;
  options.deadline = settings.deadline;
  options.recorded = settings.recorded;
  options.progress = [progress = progress_of(observer, set + ": scenarios"),
                      all = settings.scenarios.size()](std::size_t done) { progress(done, all); };
  return options;
}

std::optional<std::vector<EnduranceResult>> extend_scenarios(const RolloutSettings& settings,
                                                             const GainsToSimulate& gains,
                                                             SessionObserver& observer,
                                                             const std::atomic<bool>& stop) {
  if (settings.endurance <= 0.0 || stop) return std::nullopt;
  auto endured = endure(settings.scenarios, gains.gains_of,
                        {settings.endurance, settings.stepper, settings.workers,
                         progress_of(observer, gains.name + ": extended scenarios")},
                        stop);
  observer.part_is_over();
  return endured;
}

SimulateSession::SimulateSession(RolloutSettings settings, GainsToSimulate gains, SessionContext context,
                                 SessionObserver& observer)
    : settings_(std::move(settings)),
      gains_(std::move(gains)),
      context_(std::move(context)),
      observer_(observer) {}

void SimulateSession::examine_tasks() {
  warn_of_doubts(settings_.scenarios, observer_);
  for (const Scenario& scenario : settings_.scenarios) {
    for (const std::string& warning : warn_of_task(scenario, gains_.gains_of(scenario), observer_))
      outcome_.verdict.notes.push_back(warning);
  }
}

SimulateOutcome SimulateSession::run() {
  const auto& scenarios = settings_.scenarios;
  if (settings_.examine) examine_tasks();
  const std::string& folder = settings_.folder;
  if (!folder.empty()) {
    require_recording_memory(scenarios, settings_.record_every, settings_.workers,
                             settings_.recorded ? RecordingUse::kKept : RecordingUse::kWritten);
  }
  const FolderLock lock = make_run_folder(folder);
  const Stopwatch watch;
  outcome_.results = simulate(scenarios, gains_.gains_of,
                              simulate_options(settings_, folder, gains_.name, observer_), context_.stop);
  outcome_.seconds = watch.seconds();
  observer_.part_is_over();
  if (!folder.empty()) write_files();  // before the endurance, which may take hours
  outcome_.endured = extend_scenarios(settings_, gains_, observer_, context_.stop);
  add_unchecked(settings_.scenarios,
                check_rollouts(settings_, outcome_.results, outcome_.endured, "", outcome_.verdict),
                outcome_.verdict);
  add_engine_assumption(settings_.engine, "the scenarios", outcome_.verdict);
  add_assumptions(scenarios, settings_.stepper, outcome_.verdict, settings_.examine);
  add_controller_assumption(scenarios, gains_.gains_of(scenarios.front()), outcome_.verdict);
  if (!folder.empty()) write_conclusion();
  if (!context_.stop) {
    outcome_.ending = outcome_.verdict.passed() ? Ending::kPassed : Ending::kChecksFailed;
  }
  return std::move(outcome_);
}

void SimulateSession::write_errors(const YardstickFiles& yardstick) {
  write_text_file(settings_.folder + "/errors.csv", errors_csv(outcome_.results, yardstick.errors));
  std::vector<FileColumns> columns = {{"errors.csv", error_columns(yardstick.errors)},
                                      {"rollout_*.csv", rollout_columns(settings_.scenarios)}};
  columns.insert(columns.end(), yardstick.columns.begin(), yardstick.columns.end());
  write_text_file(settings_.folder + "/columns.csv", columns_csv(columns));
}

void SimulateSession::write_files() {
  const auto& scenarios = settings_.scenarios;
  const std::string& folder = settings_.folder;
  write_errors({});
  write_text_file(folder + "/gains.yaml",
                  gains_yaml(gains_.gains_of(scenarios.front()),
                             {gains_.path.empty() ? gains_.name : "from " + shown_path(gains_.path)}));
  RunRecord record;
  record.kind = RunKind::kSimulate;
  record.command = context_.invocation.line;
  record.wall_seconds = outcome_.seconds;
  record.seed = scenarios.front().seed;
  record.workers = settings_.workers;
  record.simulation = {settings_.stepper, settings_.engine, hash_of_file(folder + "/gains.yaml")};
  FilesRead files;
  if (!gains_.path.empty()) files.inputs = files_of_gains(gains_.path);
  add_inputs(scenarios, files.inputs);
  write_run_record(folder, std::move(record), files);
  outcome_.files = {"errors.csv", "rollout_<scenario>.csv", "columns.csv", "gains.yaml", kRunRecord,
                    "inputs/"};
  if (settings_.mcap) outcome_.files.emplace_back("rollout_<scenario>.mcap");
  if (!settings_.yardstick || context_.stop) return;
  const YardstickFiles yardstick = settings_.yardstick(folder, scenarios, gains_.gains_of);
  write_errors(yardstick);
  outcome_.files.insert(outcome_.files.end(), yardstick.written.begin(), yardstick.written.end());
}

void SimulateSession::write_conclusion() {
  if (!context_.stop) {
    write_verdict(settings_.folder, outcome_.verdict);
    outcome_.files.emplace_back("verdict.yaml");
  }
  const auto pages = add_report(
      settings_.folder,
      [this] {
        return report::scene_of(settings_.scenarios, {{stem(gains_.name), ".", "errors.csv"}},
                                gains_.gains_of(settings_.scenarios.front()).obstacleInfluenceRadius);
      },
      observer_);
  outcome_.files.insert(outcome_.files.end(), pages.begin(), pages.end());
}

}  // namespace armtune::internal
