// armtune simulate: scenarios under one set of gains.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "core/common/error.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/rollout/recorder.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/conclusion.hpp"
#include "tuner/cli/endurance_option.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/report_file.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/task_notes.hpp"
#include "tuner/cli/yardstick_option.hpp"
#include "tuner/rollouts/comparison.hpp"
#include "tuner/rollouts/recording_memory.hpp"
#include "tuner/rollouts/simulate.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/verdict/assumptions.hpp"
#include "tuner/verdict/rollout_checks.hpp"

namespace armtune::cli {
namespace {

struct Arguments {
  std::vector<std::string> scenarios;
  std::string gains = "published";
  std::string theta;
  std::string stepper = "midpoint";
  std::string engine = "simbody";
  std::string folder;
  int workers = default_workers();
  int record_every = 5;
  double deadline = 0.0;
  double endurance = 0.0;  ///< minutes; 0: none
  bool yardstick = false;
};

void write_errors(const std::string& folder, const std::vector<Scenario>& scenarios,
                  const std::vector<ScenarioResult>& results, const YardstickFiles& yardstick) {
  write_text_file(folder + "/errors.csv", errors_csv(results, yardstick.errors));
  std::vector<FileColumns> columns = {{"errors.csv", error_columns(yardstick.errors)},
                                      {"rollout_*.csv", rollout_columns(scenarios)}};
  columns.insert(columns.end(), yardstick.columns.begin(), yardstick.columns.end());
  write_text_file(folder + "/columns.csv", columns_csv(columns));
}

void write_files(const Arguments& args, const std::vector<Scenario>& scenarios,
                 const std::vector<ScenarioResult>& results, double seconds) {
  const std::string& folder = args.folder;
  const auto joints = joint_names(*scenarios.front().robot);
  const std::string gains_path = find_data_file("gains", args.gains);
  write_errors(folder, scenarios, results, {});
  write_text_file(folder + "/gains.yaml",
                  gains_yaml(load_gains(args.gains, joints), {"from " + shown_path(gains_path)}));
  Provenance p;
  p.command = command_line();
  p.inputs = {gains_path};
  add_inputs(scenarios, p.inputs);
  p.workers = args.workers;
  p.wall_seconds = seconds;
  p.extra = {{"stepper", args.stepper},
             {"engine", args.engine},
             {"gains_file", hash_of_file(folder + "/gains.yaml")}};
  p.seed = scenarios.front().seed;
  write_provenance(folder, p);
}

/// Checks the scenarios that were simulated, and the extended ones if every one of them ended.
SimulationVerdict verdict_of(const std::vector<Scenario>& scenarios,
                             const std::vector<ScenarioResult>& results,
                             const std::vector<EnduranceResult>& endured, Stepper stepper) {
  SimulationVerdict verdict;
  add_rollout_checks(results, "", verdict);
  add_contact_check(scenarios, results, "", verdict);
  const bool extended = endured.size() == scenarios.size();
  if (extended) add_endurance_checks(endured, VerdictThresholds(), "", verdict);
  add_unchecked(extended, verdict);
  add_assumptions(scenarios, stepper, verdict);
  return verdict;
}

int run(const Arguments& args) {
  if (args.yardstick && args.folder.empty())
    throw InputError("--yardstick reads the recordings of a run folder; name one with --out");
  std::vector<Scenario> scenarios;
  for (const std::string& name : args.scenarios) {
    scenarios.push_back(load_scenario(name));
    if (!args.theta.empty()) start_theta_from(args.theta, scenarios.back());
  }
  for (const Scenario& scenario : scenarios) {
    warn_of_task(scenario, load_gains(args.gains, joint_names(*scenario.robot)));
  }
  SimulateOptions options;
  options.stepper = stepper_from_name(args.stepper);
  options.engine = engine_from_name(args.engine);
  options.workers = args.workers;
  options.folder = args.folder;
  options.record_stride = args.record_every;
  options.deadline = args.deadline;
  if (!args.folder.empty()) require_recording_memory(scenarios, args.record_every, args.workers);
  const FolderLock lock = make_run_folder(args.folder);

  ProgressLine line;
  options.progress = [&](std::size_t done) {
    line.show(fmt::format("{} of {} scenarios", done, scenarios.size()));
  };
  const auto began = std::chrono::steady_clock::now();
  const auto results = simulate(
      scenarios, [&](const Scenario& s) { return load_gains(args.gains, joint_names(*s.robot)); }, options,
      stop_requested());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - began;
  line.clear();
  // Before what takes longer: an endurance or a yardstick may take hours.
  YardstickFiles yardstick;
  if (!args.folder.empty()) {
    write_files(args, scenarios, results, elapsed.count());
    if (args.yardstick && !stop_requested()) {
      yardstick = write_yardstick(args.folder, scenarios, [&args](const Scenario& s) {
        return load_gains(args.gains, joint_names(*s.robot));
      });
      write_errors(args.folder, scenarios, results, yardstick);
    }
  }

  double simulated = 0.0;
  for (const ScenarioResult& r : results) simulated += r.result.end_time;
  std::string told = comparison_table({{args.gains, results}}, all_metrics()) +
                     fmt::format("{:.4g} s simulated in {:.3g} s: {:.3g} times real time on {} workers\n",
                                 simulated, elapsed.count(), simulated / elapsed.count(), args.workers);
  std::vector<EnduranceResult> endured;
  if (args.endurance > 0.0 && !stop_requested()) {
    endured = run_endurance(
        scenarios, [&](const Scenario& s) { return load_gains(args.gains, joint_names(*s.robot)); },
        {args.endurance, options.stepper, args.workers, {}}, args.gains);
    told += fmt::format("\nEvery scenario extended to at least {:.4g} minutes:\n{}", args.endurance,
                        endurance_table(endured));
  }
  const SimulationVerdict verdict = verdict_of(scenarios, results, endured, options.stepper);
  if (!args.folder.empty()) {
    if (!stop_requested()) write_verdict(args.folder, verdict);
    const std::string report = add_report(args.folder, [&] {
      const Gains gains = load_gains(args.gains, joint_names(*scenarios.front().robot));
      return report::scene_of(scenarios, {{stem(args.gains), ".", "errors.csv"}},
                              gains.obstacleInfluenceRadius);
    });
    told += fmt::format(
        "wrote {}: errors.csv, rollout_<scenario>.csv, columns.csv, gains.yaml, run.yaml, inputs/, "
        "verdict.yaml{}{}\n",
        args.folder, yardstick.written, report);
  }
  say(told);
  if (stop_requested()) return kInterrupted;
  return conclude(verdict);
}

}  // namespace

void add_simulate_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("simulate", "Simulate scenarios and report errors and limits");
  command->add_option("SCENARIO", args->scenarios, "bundled scenarios or YAML files of your own")->required();
  command->add_option("--gains", args->gains, "bundled gains or a YAML file")->capture_default_str();
  command->add_option("--theta", args->theta,
                      "theta.yaml that the controller starts from, in place of what the scenarios say");
  add_stepper_option(*command, args->stepper);
  add_engine_option(*command, args->engine);
  command->add_option("--out", args->folder,
                      "new folder for errors.csv, rollout_<scenario>.csv, report.html and the rest");
  command->add_option("--workers", args->workers, "threads")
      ->check(CLI::Range(1, 1024))
      ->default_str(kWorkersDefault);
  command
      ->add_option("--record-every", args->record_every, "control periods per row of rollout_<scenario>.csv")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("--rollout-deadline", args->deadline, kScenarioDeadlineHelp)
      ->check(CLI::PositiveNumber);
  add_endurance_option(*command, args->endurance);
  add_yardstick_option(*command, args->yardstick);
  command->footer([] {
    return fmt::format(
        "Bundled scenarios: {}\nBundled gains: {}\n\n"
        "Example:\n  armtune simulate moving_target --gains extended_tuned --out runs/moving_target\n",
        fmt::join(bundled_names("scenarios"), " "), fmt::join(bundled_names("gains"), " "));
  });
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::cli
