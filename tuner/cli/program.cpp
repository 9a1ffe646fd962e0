#include "armtune/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstring>
#include <sstream>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/common/message_text.hpp"
#include "tuner/cli/command_parser.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/shell_words.hpp"
#include "tuner/cli/standard_streams.hpp"
#include "tuner/run/arithmetic.hpp"

namespace armtune::internal::cli {
namespace {

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

/// Converts `armtune help` to `armtune --help`, and `armtune help tune` to `armtune tune --help`.
std::vector<std::string> without_help_as_command(std::vector<std::string> words) {
  if (words.size() < 2 || words[1] != "help") return words;
  words.erase(words.begin() + 1);
  words.insert(words.begin() + (words.size() > 1 ? 2 : 1), "--help");
  return words;
}

int parse_and_run(int argc, char** argv) {
  const InputRecord inputs;  // each input file is read only once
  program_name() = argv[0];
  command_words() = resumed_arguments(without_help_as_command({argv, argv + argc}));
  command_line() = repeating_command(command_words());

  CLI::App app{"", "armtune"};
  int exit_code = kDone;
  declare_program(app, exit_code);
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
