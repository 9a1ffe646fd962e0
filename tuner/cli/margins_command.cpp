// The command `armtune margins`, which finds the stability margins of a gain set: extra delay, gain, control
// rate and noise.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "tuner/cli/commands.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/robustness/margin_report.hpp"
#include "tuner/session/margins_session.hpp"

namespace armtune::internal::cli {
namespace {

struct MarginsArguments {
  std::string set;
  std::vector<std::string> scenarios;
  std::vector<std::string> limits;
  std::string stepper = "midpoint";
  MarginsSettings settings = {};
};

int run_margins(const MarginsArguments& args) {
  MarginsSettings settings = args.settings;
  settings.options.stepper = stepper_from_name(args.stepper);
  settings.options.limits = parse_limits(args.limits);
  // The default scenarios are four motions, each with the ideal arm and with the realistic arm.
  settings.scenarios = scenarios_of(
      args.set, args.scenarios,
      {"fixed_target", "moving_target", "target_switch", "obstacle_pass", "realistic_fixed_target",
       "realistic_moving_target", "realistic_target_switch", "realistic_obstacle_pass"});
  const GainSet set = load_gain_set(args.set, settings.scenarios);
  settings.gains = set.gains;
  settings.gains_path = set.path;
  SessionPrinter printer;
  const MarginsOutcome outcome = MarginsSession(settings, session_context(), printer).run();
  if (!outcome.margins.empty()) {
    say(fmt::format("{}\n{}", margins_by_scenario(settings.scenarios, outcome.margins),
                    margins_table(settings.scenarios, {{args.set, outcome.margins}})));
  }
  if (!outcome.files.empty())
    say(fmt::format("\nwrote {}: {}\n", settings.folder, fmt::join(outcome.files, ", ")));
  return static_cast<int>(outcome.ending);
}

std::string help_footer() {
  std::string text =
      "Margins (only one quantity at a time is changed from its value in the scenario or in the gains file):\n";
  for (const MarginField& field : margin_fields()) {
    text += fmt::format("  {:<16} {} [{}]\n", field.name, field.meaning, field.unit);
  }
  text += fmt::format(
      "\n"
      "The closed loop counts as stable if its rollout completes, keeps the limits, and has saturated\n"
      "torques in at most {} % of the control periods. An unstable loop chatters between the torque limits\n"
      "long before it diverges or tracks much worse. The search moves away from the nominal value in steps\n"
      "until the loop fails. It then bisects until a delay is known to one control period, and any other\n"
      "quantity to 2 %. A margin is 'none' if the loop fails at the nominal value already.\n"
      "\nExample:\n  armtune margins extended_tuned --scenarios moving_target realistic_moving_target "
      "--limit 'joint_velocity/max_ratio<=0.9'\n",
      100.0 * kSaturatedShare);
  return text;
}

}  // namespace

void add_margins_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<MarginsArguments>();
  args->settings.options.workers = default_workers();
  CLI::App* command = app.add_subcommand(
      "margins", "Find stability margins by bisection: extra delay, gain, control rate, noise");
  command->add_option("RUN_OR_GAINS", args->set, "run folder, gains file or bundled gains")->required();
  command->add_option("--scenarios", args->scenarios, "scenarios to simulate")
      ->default_str(
          "all scenarios in the run's study; without a study: fixed_target, moving_target, "
          "target_switch, obstacle_pass and their realistic_ variants");
  command->add_option("--limit", args->limits, kLimitHelp)->default_str(kLimitDefault);
  add_stepper_option(*command, args->stepper);
  command->add_option("--out", args->settings.folder, "new folder for margins.csv, verdict.yaml and run.json")
      ->default_str("no files");
  command
      ->add_option("--workers", args->settings.options.workers,
                   "number of threads; results do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->default_str(kWorkersDefault);
  command->footer(help_footer);
  command->callback([args, &exit_code] { exit_code = run_margins(*args); });
}

}  // namespace armtune::internal::cli
