#include "tuner/cli/command_parser.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/common/nearest.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/declared/short_help.hpp"
#include "tuner/cli/xacro_options.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal::cli {
namespace {

std::string version_text() {
  std::string text;
  for (const auto& [name, version] : versions()) text += fmt::format("{} {}\n", name, version);
  text.pop_back();
  return text;
}

void add_commands(CLI::App& app, int& exit_code) {
  add_robot_command(app, exit_code);
  add_logs_command(app, exit_code);
  add_init_command(app, exit_code);
  add_simulate_command(app, exit_code);
  add_tune_command(app, exit_code);
  add_pareto_command(app, exit_code);
  add_sensitivity_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_export_command(app, exit_code);
  add_robustness_command(app, exit_code);
  add_margins_command(app, exit_code);
  add_report_command(app, exit_code);
  add_controllers_command(app, exit_code);
  add_metrics_command(app, exit_code);
  add_algorithms_command(app, exit_code);
#ifdef ARMTUNE_SUITESPARSE
  add_excite_command(app, exit_code);
  add_identify_command(app, exit_code);
  add_validate_command(app, exit_code);
  add_calibrate_command(app, exit_code);
  add_plan_command(app, exit_code);
  add_yardstick_command(app, exit_code);
#endif
  add_man_command(app, exit_code);
  add_completion_command(app, exit_code);
  add_xacro_options(app);
  group_options(app);
}

}  // namespace

void declare_program(CLI::App& app, int& exit_code) {
  app.description(
      "Offline gain tuning for robot arms: simulates an arm in closed loop with its controller, in Simbody, "
      "and tunes the controller's gains with NLopt, so that tracking errors fall while every joint keeps "
      "its limits.\n\nTo begin:  armtune simulate moving_target\n"
      "then:      armtune tune ur10_gaze --max-evaluations 100");
  app.formatter(help_formatter());
  app.set_help_all_flag("--help-all", "Print help with every option and exit");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, and every simulation check passed; 1 failed; 2 wrong usage or bad input; 3 done, "
      "but a simulation check failed or nothing feasible was found; 130 interrupted (a run that can be "
      "resumed has saved everything so far).");
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return fmt::format("armtune: {}; see 'armtune --help' or 'armtune COMMAND --help'\n",
                       one_line(error.what()));
  });
  add_commands(app, exit_code);
}

void refuse_unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.size() < 2 || words[1].starts_with('-')) return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), words[1]) != names.end()) return;
  throw InputError(one_line(fmt::format("there is no command '{}'{}; armtune --help lists all commands",
                                        words[1], suggestion(words[1], names))));
}

}  // namespace armtune::internal::cli
