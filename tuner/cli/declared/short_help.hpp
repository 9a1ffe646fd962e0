#pragma once
// Selects the few options of a command that --help shows, and puts them under headings. --help-all, the
// manual page and the documentation show every option.

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
  std::vector<std::string> options;  ///< such as "--out"
};

/// The options that --help of one command shows. A command without an entry shows all of its options.
struct ShortHelp {
  std::string command;
  std::vector<OptionGroup> groups;
};

/// Largest number of options that --help shows for a command.
inline constexpr std::size_t kMostOptionsOfHelp = 10;

const std::vector<ShortHelp>& short_helps();

/// Returns a formatter for the help of commands. Without --help-all it shows only the options of
/// short_helps(). It wraps long descriptions. Set it before adding commands, which inherit it.
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// Puts the options of every command in short_helps() under their headings. Skips commands and options that
/// this build of armtune does not have.
void group_options(CLI::App& app);

}  // namespace armtune::internal::cli
