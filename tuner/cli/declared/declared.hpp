#pragma once
// The program's commands and options, with their meanings, as plain data. They are read from the same
// declarations that --help shows. The manual page and the shell completion are generated from them.

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace armtune::internal::cli {

struct DeclaredOption {
  std::vector<std::string> names;    ///< such as "--out"; a positional has one, such as "STUDY"
  std::string value;                 ///< type of its value, such as "TEXT"; empty for a switch
  std::string otherwise;             ///< default; empty: none
  std::vector<std::string> choices;  ///< the only values allowed; empty: any
  std::string meaning;
  bool positional = false;
  bool required = false;
  bool many = false;  ///< true if it takes several values
};

struct DeclaredCommand {
  std::string name;
  std::string meaning;
  std::vector<DeclaredOption> options;  ///< in the order of their declaration, including positionals
  std::string footer;                   ///< text that --help shows below the options
};

/// The whole program. `app` has its own options; `commands` are in the order of --help.
struct DeclaredProgram {
  DeclaredCommand app;
  std::vector<DeclaredCommand> commands;
};

DeclaredProgram declared(const CLI::App& app, const std::string& name);

/// Returns the default of an option, as a value or in words; empty if no default is declared.
std::string default_of(const CLI::Option& option);

/// Returns the folder of bundled data, such as "studies", if the value of the option can be the name of a
/// file in this folder; otherwise an empty text. The option may be a positional argument.
std::string bundled_kind(const DeclaredOption& option);

}  // namespace armtune::internal::cli
