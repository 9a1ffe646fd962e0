// The command `armtune robustness`, which simulates a gain set on many randomly changed models of the arm. It
// counts how many of them keep their limits.

#include <CLI/CLI.hpp>
#include <memory>

#include "tuner/cli/commands.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/monte_carlo_printer.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/uncertainty_options.hpp"

namespace armtune::internal::cli {
namespace {

struct RobustnessArguments {
  std::string set;
  std::vector<std::string> scenarios;
  std::vector<std::string> limits;
  std::string stepper = "midpoint";
  long only = -1;
  long seed = 1;
  UncertaintyArguments uncertainty = {};
  MonteCarloSettings settings = {};
};

int run_robustness(const RobustnessArguments& args, RankGroup& team) {
  MonteCarloSettings settings = args.settings;
  MonteCarloOptions& options = settings.options;
  options.stepper = stepper_from_name(args.stepper);
  options.seed = static_cast<std::uint64_t>(args.seed);
  options.limits = parse_limits(args.limits);
  if (args.only >= 0) {
    options.first = static_cast<std::uint64_t>(args.only);
    options.samples = 1;
    settings.writes_arm = true;
  }
  // The default scenarios are those in which the arm comes near its limits.
  settings.scenarios = load_inputs(settings.place, [&args] {
    return scenarios_of(args.set, args.scenarios, {"realistic_target_switch", "realistic_obstacle_pass"});
  });
  options.perturbation =
      load_inputs(settings.place, [&] { return perturbation_of(args.uncertainty, settings.scenarios); });
  const GainSet set =
      load_inputs(settings.place, [&] { return load_gain_set(args.set, settings.scenarios); });
  settings.gains = set.gains;
  settings.gains_path = set.path;
  if (settings.place.folder.empty() && args.only < 0)
    settings.place.folder = default_run_folder("robustness");
  MonteCarloPrinter printer(settings);
  const auto outcome = MonteCarloSession(settings, session_context(), printer).run(team);
  return outcome ? printer.ended(*outcome) : kDone;
}

}  // namespace

void add_robustness_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<RobustnessArguments>();
  args->settings.options.workers = default_workers();
  CLI::App* command = app.add_subcommand(
      "robustness",
      "Simulate gains on randomly changed models of the arm, and report how many of these keep all limits");
  command->add_option("RUN_OR_GAINS", args->set, "run folder, gains file or bundled gains")->required();
  command->add_option("--scenarios", args->scenarios, "scenarios to simulate")
      ->default_str(
          "all scenarios in the run's study; without a study: realistic_target_switch and "
          "realistic_obstacle_pass");
  command->add_option("--samples", args->settings.options.samples, "number of random arms")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("--seed", args->seed, "seed of the random arms")
      ->check(CLI::Range(0L, 1000000000000L))
      ->capture_default_str();
  command
      ->add_option(
          "--sample", args->only,
          "simulate only the random arm with this number; its result is the same as in a run with all arms. "
          "With --out, the arm is written as arm.urdf and arm.yaml")
      ->check(CLI::Range(0L, 1000000000L));
  command->add_option("--limit", args->limits, kLimitHelp)->default_str(kLimitDefault);
  add_uncertainty_options(*command, args->uncertainty);
  add_stepper_option(*command, args->stepper);
  add_run_options(*command, "new folder for samples.csv, summary.csv, verdict.yaml, run.json and report.html",
                  "runs/robustness_<time>, or no files with --sample", args->settings.place,
                  args->settings.options.workers, args->settings.deadline);
  command->footer(
      "Example:\n  armtune robustness extended_tuned --scenarios identified_realistic_target_switch "
      "--limit 'joint_velocity/max_ratio<=0.9'\n");
  command->callback([args, &exit_code] { exit_code = run_robustness(*args, team()); });
}

}  // namespace armtune::internal::cli
