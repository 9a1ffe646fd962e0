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
  line.show("the nominal rollouts");
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
      "Margins (each searched alone, everything else as the scenario and the gains have it):\n";
  for (const MarginField& field : margin_fields()) {
    text += fmt::format("  {:<16} {} [{}]\n", field.name, field.meaning, field.unit);
  }
  text += fmt::format(
      "\nA closed loop holds if its rollout completes, keeps the limits, and saturates a joint's torque in "
      "at\nmost {} % of the control periods: a loop that is unstable chatters from bound to bound, long before "
      "it\ndiverges or tracks much worse. The search strides away from the nominal value to the first failure "
      "and\nbisects: to adjacent periods, or to 2 %. A margin is 'none' where not even the nominal value stands.\n"
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
  command->add_option("RUN_OR_GAINS", args->set, "a run folder, bundled gains or a YAML file")->required();
  command->add_option(
      "--scenarios", args->scenarios,
      "scenarios that are simulated (default: those of the run's study; of gains alone fixed_target, "
      "moving_target, target_switch, obstacle_pass and their realistic_ variants");
  command->add_option("--limit", args->limits,
                      "METRIC<=VALUE or METRIC>=VALUE, may be repeated (default: joint "
                      "velocities and positions inside the arm's own, and no obstacle touched");
  add_stepper_option(*command, args->stepper);
  command->add_option("--out", args->folder, "new folder for margins.csv and run.yaml");
  command->add_option("--workers", args->options.workers, "threads; results do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->default_str(kWorkersDefault);
  command->footer(help_footer);
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::internal::cli
