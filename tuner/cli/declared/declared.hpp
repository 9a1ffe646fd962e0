#pragma once
// What the command line was declared with, as plain data: the manual page and shell completion are made from
// it, as
// --help is.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace armtune::internal::cli {

struct DeclaredOption {
  std::vector<std::string> names;    ///< "--out"; of a positional its one name, "STUDY"
  std::string value;                 ///< what it takes, "TEXT"; empty for a switch
  std::string otherwise;             ///< its default; empty: none
  std::vector<std::string> choices;  ///< the only words that it takes; empty: any
  std::string meaning;
  bool positional = false;
  bool required = false;
  bool many = false;  ///< takes several values
};

struct DeclaredCommand {
  std::string name;
  std::string meaning;
  std::vector<DeclaredOption> options;  ///< in the order of their declaration, positionals among them
  std::string footer;                   ///< what --help says below the options
};

/// The program's own options stand in `app`; its commands are in the order of --help.
struct DeclaredProgram {
  DeclaredCommand app;
  std::vector<DeclaredCommand> commands;
};

DeclaredProgram declared(const CLI::App& app, const std::string& name);

/// The folder of bundled data ("studies") whose names an option or positional of this name takes; empty:
/// none.
std::string bundled_kind(const DeclaredOption& option);

}  // namespace armtune::internal::cli
