#pragma once
// Decides which options of a command --help shows, under which headings. --help-all, the manual page and the
// documentation show every option.

#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class FormatterBase;
}  // namespace CLI

namespace armtune::internal::cli {

struct OptionGroup {
  std::string heading;
  std::vector<std::string> options;  ///< "--out"
};

/// The options that --help of one command shows. A command without an entry shows all of its options.
struct ShortHelp {
  std::string command;
  std::vector<OptionGroup> groups;
};

/// --help shows at most so many options of a command.
inline constexpr std::size_t kMostOptionsOfHelp = 10;

const std::vector<ShortHelp>& short_helps();

/// Prints the help of commands: without --help-all only the options of short_helps(). Long descriptions are
/// wrapped. The program gets it before its commands are added, which take it over.
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// Puts the options of every command that short_helps() names under their headings. Skips what was not built.
void group_options(CLI::App& app);

}  // namespace armtune::internal::cli
