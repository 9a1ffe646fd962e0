// The command `armtune compare`, which simulates several gain sets in the same scenarios.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "sim/scenario/robot_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/compare_gains.hpp"
#include "tuner/cli/endurance_option.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/mcap_option.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/rollouts_printer.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/cli/set_labels.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal::cli {
namespace {

namespace fs = std::filesystem;

struct CompareArguments {
  std::vector<std::string> sets;
  std::vector<std::string> scenarios;
  std::string stepper = "midpoint";
  bool all_metrics = false;
  bool gains_only = false;
  std::string robot;  ///< used only with --gains
  RolloutSettings settings = {};
};

/// Returns the scenarios that the user named, else those of the first run folder's study, else those of the
/// bundled study ur10_gaze.
std::vector<Scenario> compared_scenarios(const CompareArguments& args) {
  const auto run = std::find_if(args.sets.begin(), args.sets.end(), [](const std::string& set) {
    std::error_code ignored;
    return fs::exists(fs::path(set) / "study.yaml", ignored);
  });
  if (args.scenarios.empty() && run == args.sets.end()) return load_study("ur10_gaze").scenarios;
  return scenarios_of(run == args.sets.end() ? std::string() : *run, args.scenarios, {});
}

int run_compare(const CompareArguments& args) {
  if (args.gains_only) {
    say_gains_difference(
        args.sets, args.robot.empty() ? *compared_scenarios(args).front().robot : *load_robot(args.robot),
        args.robot.empty());
    return kDone;
  }
  RolloutSettings settings = args.settings;
  const std::vector<std::string> labels = set_labels(args.sets);
  if (!settings.folder.empty()) check_labels(labels, args.sets);
  settings.scenarios = compared_scenarios(args);
  settings.stepper = stepper_from_name(args.stepper);
  std::vector<GainsToSimulate> sets;
  for (std::size_t i = 0; i < args.sets.size(); ++i)
    sets.push_back(gains_to_simulate(labels[i], gains_name(args.sets[i])));
  SessionPrinter<> printer;
  const CompareOutcome outcome = CompareSession(settings, sets, session_context(), printer).run();
  print_compared(outcome, settings, args.all_metrics ? all_metrics() : headline_metrics());
  return static_cast<int>(outcome.ending);
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<CompareArguments>();
  RolloutSettings& settings = args->settings;
  settings.workers = default_workers();
  CLI::App* command = app.add_subcommand(
      "compare", "Simulate gain sets in the same scenarios; print one table, with ratios to the first set");
  command->add_option("RUN_OR_GAINS", args->sets, "run folders, gains files or bundled gains")->required();
  command->add_option("--scenarios", args->scenarios, "scenarios to simulate")
      ->default_str(
          "all scenarios in the study of the first given run folder; without a run folder, those of "
          "the bundled study ur10_gaze");
  CLI::Option* stepper = add_stepper_option(*command, args->stepper);
  CLI::Option* workers = command->add_option("--workers", settings.workers, "number of threads")
                             ->check(CLI::Range(1, 1024))
                             ->default_str(kWorkersDefault);
  CLI::Option* deadline = command->add_option("--rollout-deadline", settings.deadline, kScenarioDeadlineHelp)
                              ->check(CLI::PositiveNumber)
                              ->default_str(kDeadlineDefault);
  CLI::Option* endurance = add_endurance_option(*command, settings.endurance);
  CLI::Option* all = command->add_flag("--all-metrics", args->all_metrics,
                                       "print every metric instead of only the most important ones");
  CLI::Option* folder = command
                            ->add_option("--out", settings.folder,
                                         "new folder for comparison.csv, errors_<set>.csv and report.html")
                            ->default_str("no files");
  add_mcap_option(*command, settings.mcap)->needs(folder);
  CLI::Option* gains = command->add_flag("--gains", args->gains_only,
                                         "print only the gains that differ, side by side; nothing is "
                                         "simulated");
  for (CLI::Option* of_simulation : {stepper, workers, deadline, endurance, all, folder})
    gains->excludes(of_simulation);
  command
      ->add_option("--robot", args->robot,
                   "arm that the gains are made for: a bundled robot, a robot YAML or a URDF")
      ->default_str("the arm of the first scenario")
      ->needs(gains);
  command->footer([] {
    return std::string("Example:\n  armtune compare published extended_tuned --scenarios fixed_target\n");
  });
  command->callback([args, &exit_code] { exit_code = run_compare(*args); });
}

}  // namespace armtune::internal::cli
