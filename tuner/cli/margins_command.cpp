// armtune margins: the stability margins of a gain set: extra delay, gain, control rate and noise.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "sim/csv/text_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/robustness/margin_report.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune::internal::cli {
namespace {

struct Arguments {
  std::string set;
  std::vector<std::string> scenarios;
  std::vector<std::string> limits;
  std::string folder;
  std::string stepper = "midpoint";
  MarginOptions options;
};

int run(Arguments args) {
  MarginOptions& options = args.options;
  options.stepper = stepper_from_name(args.stepper);
  options.limits = parse_limits(args.limits);
  // Unless others are asked for: the task's own, on the arm of the model and on the realistic one.
  const std::vector<Scenario> scenarios = scenarios_of(
      args.set, args.scenarios,
      {"fixed_target", "moving_target", "target_switch", "obstacle_pass", "realistic_fixed_target",
       "realistic_moving_target", "realistic_target_switch", "realistic_obstacle_pass"});
  const GainSet set = load_gain_set(args.set, scenarios);
  const FolderLock lock = make_run_folder(args.folder);

  const Stopwatch watch;
  ProgressLine line;
  line.show("simulating the nominal rollouts");
  options.progress = [&](std::size_t done, std::size_t all) {
    line.show(fmt::format("{} of {} margins, {:.0f} s left", done, all,
                          watch.seconds() / static_cast<double>(done) * static_cast<double>(all - done)));
  };
  if (!args.folder.empty()) {
    options.finished = [&](const std::vector<Margin>& so_far) {
      write_text_file(args.folder + "/margins.csv", margins_csv(scenarios, so_far));
    };
  }
  const auto found = margins(scenarios, set.gains, options, stop_requested());
  line.clear();
  if (!args.folder.empty()) {
    write_text_file(args.folder + "/margins.csv", margins_csv(scenarios, found));
    Provenance p;
    p.command = command_line();
    p.inputs = {set.path};
    add_inputs(scenarios, p.inputs);
    p.workers = options.workers;
    p.wall_seconds = watch.seconds();
    p.extra = {{"margins", fmt::format("{}", found.size())}, {"stepper", args.stepper}};
    write_provenance(args.folder, p);
  }
  if (!found.empty()) {
    say(fmt::format("{}\n{}", margins_by_scenario(scenarios, found),
                    margins_table(scenarios, {{args.set, found}})));
  }
  if (!args.folder.empty()) say(fmt::format("\nwrote {}: margins.csv, run.yaml, inputs/\n", args.folder));
  if (stop_requested()) return kInterrupted;
  const auto holds = [](const Margin& m) { return m.stands.has_value(); };
  return std::all_of(found.begin(), found.end(), holds) ? kDone : kChecksFailed;
}

std::string help_footer() {
  std::string text =
      "Margins (only one quantity at a time is changed from its value in the scenario or the gains):\n";
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
  auto args = std::make_shared<Arguments>();
  args->options.workers = default_workers();
  CLI::App* command = app.add_subcommand(
      "margins", "Find stability margins by bisection: extra delay, gain, control rate, noise");
  command->add_option("RUN_OR_GAINS", args->set, "run folder, gains file or bundled gains")->required();
  command->add_option(
      "--scenarios", args->scenarios,
      "scenarios to simulate (default: all scenarios in the run's study; without a study: fixed_target, "
      "moving_target, target_switch, obstacle_pass and their realistic_ variants)");
  command->add_option(
      "--limit", args->limits,
      "limit that every rollout must keep: METRIC<=VALUE or METRIC>=VALUE; may be repeated "
      "(default: the arm's limits of velocity, position and, if its file has them, acceleration; and "
      "no contact)");
  add_stepper_option(*command, args->stepper);
  command->add_option("--out", args->folder, "new folder for margins.csv and run.yaml (default: no files)");
  command->add_option("--workers", args->options.workers, "number of threads; results do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->default_str(kWorkersDefault);
  command->footer(help_footer);
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::internal::cli
