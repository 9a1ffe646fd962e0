#include "tests/cli/support/refused_command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/common/input_file.hpp"
#include "core/common/message_text.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tuner/cli/command_parser.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/on_ranks.hpp"

namespace armtune::internal::test {
namespace {

/// Runs the command in this process.
int run_here(std::vector<std::string> arguments) {
  const InputRecord inputs;
  cli::command_words() = arguments;
  cli::command_words().insert(cli::command_words().begin(), "armtune");
  CLI::App app{"", "armtune"};
  int exit_code = 0;
  cli::declare_program(app, exit_code);
  std::reverse(arguments.begin(), arguments.end());  // the order that CLI11 expects
  return cli::on_ranks("", [&] {
    try {
      app.parse(arguments);
    } catch (const CLI::ParseError& error) {
      throw InputError(one_line(error.what()));
    }
    return exit_code;
  });
}

}  // namespace

InputError refused_command(const std::vector<std::string>& arguments) {
  const Finished finished = run_program(arguments);
  EXPECT_EQ(finished.exit_code, 2) << finished.err;
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  const InputError error = input_error([&arguments] { return run_here(arguments); });
  EXPECT_THAT(finished.err, testing::StartsWith(std::string("armtune: ") + error.what()));
  return error;
}

}  // namespace armtune::internal::test
