#pragma once
// Declares the command line of the program to CLI11: the commands, the program's own options, and the help.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace armtune::internal::cli {

/// Declares every command and option. A command that runs writes its exit code into `exit_code`, which must
/// outlive the parser.
void declare_program(CLI::App& app, int& exit_code);

/// Throws InputError if the command does not exist. The message suggests the command with the nearest name.
/// words: the command line, with the program's name.
void refuse_unknown_command(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace armtune::internal::cli
