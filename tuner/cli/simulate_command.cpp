// The command `armtune simulate`, which simulates scenarios with one gain set.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "armtune/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/endurance_option.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/mcap_option.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/rollouts_printer.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/cli/yardstick_option.hpp"

namespace armtune::internal::cli {
namespace {

struct SimulateArguments {
  std::vector<std::string> scenarios;
  std::string gains = "published";
  std::string theta;
  std::string stepper = "midpoint";
  std::string engine = "simbody";
  bool yardstick = false;
  RolloutSettings settings = {};
};

int run_simulate(const SimulateArguments& args) {
  RolloutSettings settings = args.settings;
  if (args.yardstick && settings.folder.empty())
    throw InputError("--yardstick needs the recordings in a run folder; give a new folder with --out");
  for (const std::string& name : args.scenarios) {
    settings.scenarios.push_back(load_scenario(name));
    if (!args.theta.empty()) start_theta_from(args.theta, settings.scenarios.back());
  }
  settings.stepper = stepper_from_name(args.stepper);
  settings.engine = engine_from_name(args.engine);
  settings.yardstick = yardstick_if(args.yardstick);
  SessionPrinter<> printer;
  const SimulateOutcome outcome =
      SimulateSession(settings, gains_to_simulate(args.gains, args.gains), session_context(), printer).run();
  print_simulated(outcome, settings, args.gains);
  return static_cast<int>(outcome.ending);
}

}  // namespace

void add_simulate_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<SimulateArguments>();
  RolloutSettings& settings = args->settings;
  settings.workers = default_workers();
  CLI::App* command = app.add_subcommand("simulate", "Simulate scenarios and report errors and limits");
  command->add_option("SCENARIO", args->scenarios, "bundled scenarios or YAML files of your own")->required();
  command
      ->add_option("--gains", args->gains,
                   "bundled gains or a YAML file; 'published' are the hand-tuned ones of the UR10")
      ->capture_default_str();
  command
      ->add_option("--theta", args->theta, "theta.yaml with the initial model parameters of the controller")
      ->default_str("those of the scenarios");
  add_stepper_option(*command, args->stepper);
  add_engine_option(*command, args->engine);
  command
      ->add_option("--out", settings.folder,
                   "new folder for errors.csv, rollout_<scenario>.csv, report.html and other results")
      ->default_str("no files");
  command->add_option("--workers", settings.workers, "number of threads")
      ->check(CLI::Range(1, 1024))
      ->default_str(kWorkersDefault);
  command
      ->add_option("--record-every", settings.record_every,
                   "number of control periods between two rows of rollout_<scenario>.csv")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  add_mcap_option(*command, settings.mcap)->needs(command->get_option("--out"));
  command->add_option("--rollout-deadline", settings.deadline, kScenarioDeadlineHelp)
      ->check(CLI::PositiveNumber)
      ->default_str(kDeadlineDefault);
  add_endurance_option(*command, settings.endurance);
  add_yardstick_option(*command, args->yardstick);
  command->footer([] {
    return fmt::format(
        "Bundled scenarios: {}\nBundled gains: {}\n\n"
        "Example:\n  armtune simulate moving_target --gains extended_tuned --out runs/moving_target\n",
        fmt::join(bundled_names("scenarios"), " "), fmt::join(bundled_names("gains"), " "));
  });
  command->callback([args, &exit_code] { exit_code = run_simulate(*args); });
}

}  // namespace armtune::internal::cli
