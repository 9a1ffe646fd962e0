// armtune man, armtune completion: what is declared, in the forms that man and shells read.

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
constexpr const char* kOutHelp = "file to write it to (default: to the screen)";

void put(const std::string& text, const std::string& file) {
  file.empty() ? say(text) : write_text_file(file, text);
}

}  // namespace

void add_man_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("man", "Print the manual page");
  auto file = std::make_shared<std::string>();
  command->add_option("--out", *file, kOutHelp);
  command->footer("To read it:  armtune man | man -l -\nAn installed armtune has it as  man armtune.");
  command->callback([&app, file] {
    const auto version = versions().front();
    put(man_page(declared(app, kProgram), version.first + " " + version.second), *file);
  });
}

void add_completion_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("completion", "Print a shell's completion of armtune's commands");
  auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash or zsh")->required()->check(CLI::IsMember(shell_names()));
  auto file = std::make_shared<std::string>();
  command->add_option("--out", *file, kOutHelp);
  command->footer(
      "For this shell alone:  source <(armtune completion bash)\nAn installed armtune brings both along.");
  command->callback([&app, shell, file] { put(completion(declared(app, kProgram), *shell), *file); });
}

}  // namespace armtune::internal::cli
