// The commands `armtune man` and `armtune completion`, which print the manual page and the completion scripts
// of shells. Both are generated from the options that the program declares.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "sim/csv/text_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/declared/completion.hpp"
#include "tuner/cli/declared/man_page.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal::cli {
namespace {

constexpr const char* kProgram = "armtune";
constexpr const char* kOutHelp = "file for the output";

void put(const std::string& text, const std::string& file) {
  file.empty() ? say(text) : write_text_file(file, text);
}

}  // namespace

void add_man_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("man", "Print the manual page");
  auto file = std::make_shared<std::string>();
  command->add_option("--out", *file, kOutHelp)->default_str("standard output");
  command->footer("To read it:  armtune man | man -l -\nIf armtune is installed:  man armtune");
  command->callback([&app, file] {
    const auto version = versions().front();
    put(man_page(declared(app, kProgram), version.first + " " + version.second), *file);
  });
}

void add_completion_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand(
      "completion", "Print a script with which a shell completes armtune's commands and options");
  auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash or zsh")->required()->check(CLI::IsMember(shell_names()));
  auto file = std::make_shared<std::string>();
  command->add_option("--out", *file, kOutHelp)->default_str("standard output");
  command->footer(
      "For the current shell only:  source <(armtune completion bash)\n"
      "If armtune is installed, bash and zsh have the completion already.");
  command->callback([&app, shell, file] { put(completion(declared(app, kProgram), *shell), *file); });
}

}  // namespace armtune::internal::cli
