#include "armtune/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstring>
#include <sstream>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/common/message_text.hpp"
#include "core/common/nearest.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/declared/short_help.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/standard_streams.hpp"
#include "tuner/run/arithmetic.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal::cli {
namespace {

std::string version_text() {
  std::string text;
  for (const auto& [name, version] : versions()) text += fmt::format("{} {}\n", name, version);
  text.pop_back();
  return text;
}

/// Prints CLI11's help on standard output, or its error on standard error. Returns the exit code. CLI11
/// itself would print through std::cout, which open_standard_streams does not make safe.
int conclude_parsing(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream out;
  std::ostringstream err;
  const int code = app.exit(error, out, err);
  say(out.str());
  fmt::print(stderr, "{}", err.str());
  return code == 0 ? kDone : kBadInput;
}

void add_commands(CLI::App& app, int& exit_code) {
  add_robot_command(app, exit_code);
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
  add_plan_command(app, exit_code);
  add_yardstick_command(app, exit_code);
#endif
  add_man_command(app, exit_code);
  add_completion_command(app, exit_code);
  group_options(app);
}

/// Ends the help of every command with the program's footer, which gives the exit codes. CLI11 drops it where
/// a command has a footer of its own.
void add_exit_codes(CLI::App& app) {
  const std::string codes = app.get_footer();
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    if (!command->get_footer().ends_with(codes)) command->footer(command->get_footer() + "\n\n" + codes);
  }
}

/// Converts `armtune help` to `armtune --help`, and `armtune help tune` to `armtune tune --help`.
std::vector<std::string> without_help_as_command(std::vector<std::string> words) {
  if (words.size() < 2 || words[1] != "help") return words;
  words.erase(words.begin() + 1);
  words.insert(words.begin() + (words.size() > 1 ? 2 : 1), "--help");
  return words;
}

/// Throws InputError if the command does not exist. The message suggests the command with the nearest name.
void refuse_unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.size() < 2 || words[1].starts_with('-')) return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), words[1]) != names.end()) return;
  throw InputError(one_line(fmt::format("there is no command '{}'{}; armtune --help lists all commands",
                                        words[1], suggestion(words[1], names))));
}

int parse_and_run(int argc, char** argv) {
  const InputRecord inputs;  // each input file is read only once
  program_name() = argv[0];
  command_words() = resumed_arguments(without_help_as_command({argv, argv + argc}));
  command_line() = repeating_command(command_words());

  CLI::App app{
      "Offline gain tuning for robot arms: simulates an arm in closed loop with its controller, in Simbody, "
      "and tunes the controller's gains with NLopt, so that tracking errors fall while every joint keeps "
      "its limits.\n\nTo begin:  armtune simulate moving_target\n"
      "then:      armtune tune ur10_gaze --max-evaluations 100",
      "armtune"};
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
  int exit_code = kDone;
  add_commands(app, exit_code);
  add_exit_codes(app);
  if (argc == 1) {
    if (rank_place().rank != 0) return kDone;
    fmt::print(stderr, "{}", app.help());
    return kBadInput;
  }
  refuse_unknown_command(app, command_words());
  // This runs before the callback of the command.
  app.parse_complete_callback([&app] { refuse_ranks(app.get_subcommands().front()->get_name()); });
  try {
    std::vector<const char*> words;
    words.reserve(command_words().size());
    for (const std::string& word : command_words()) words.push_back(word.c_str());
    app.parse(static_cast<int>(words.size()), words.data());
  } catch (const CLI::ParseError& e) {
    // Rank 0 prints the error. Other ranks throw it, so that it is reported to rank 0, which may not have it.
    if (rank_place().rank != 0) throw InputError(one_line(e.what()));
    return conclude_parsing(app, e);
  }
  return exit_code;
}

/// Runs the program and returns the exit code. Does not throw.
int run(int argc, char** argv) {
  open_standard_streams();
  int exit_code = kDone;
  try {
    // This may restart the process, which takes time. --version and --help do not need it.
    if (argc > 1 && argv[1][0] != '-') fix_arithmetic(argv);
    // Rank 0 decides when the other ranks stop.
    rank_place().rank == 0 ? catch_interrupts() : ignore_interrupts();
    exit_code = on_ranks(quoted_command({argv, argv + argc}), [&] { return parse_and_run(argc, argv); });
  } catch (...) {
    exit_code = report(std::current_exception());
  }
  const int reason = flush_standard_output();
  if (reason == 0) return exit_code;
  fmt::print(
      stderr,
      "armtune: failed: cannot write all of standard output: {}; redirect the output to a writable file\n",
      std::strerror(reason));
  return exit_code == kDone ? kFailed : exit_code;
}

}  // namespace
}  // namespace armtune::internal::cli

namespace armtune {

int run_program(int argc, char** argv) {
  return internal::cli::run(argc, argv);
}

}  // namespace armtune
