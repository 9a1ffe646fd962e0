#include "tuner/cli/declared/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "sim/scenario/data_files.hpp"

namespace armtune::internal::cli {
namespace {

/// Returns the words to which an option or positional is completed.
std::vector<std::string> words_of(const DeclaredOption& option) {
  if (!option.choices.empty()) return option.choices;
  const std::string kind = bundled_kind(option);
  return kind.empty() ? std::vector<std::string>() : bundled_names(kind);
}

/// Returns the text in single quotes for a shell.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// Returns shell assignments with the words for one place of the command line. files: true if paths are
/// completed too.
std::string place(const std::vector<std::string>& words, bool files) {
  return fmt::format("words={}; files={}", quoted(fmt::format("{}", fmt::join(words, " "))), files ? 1 : 0);
}

/// Returns a bash function with a case for each command and option. zsh runs it through bashcompinit.
std::string bash(const DeclaredProgram& program) {
  std::vector<std::string> names;
  for (const DeclaredCommand& command : program.commands) names.push_back(command.name);
  for (const DeclaredOption& option : program.app.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  std::string text = fmt::format(
      "_armtune() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} words= files=0 word\n"
      "  COMPREPLY=()\n"
      "  if ((COMP_CWORD == 1)); then\n"
      "    COMPREPLY=($(compgen -W {} -- \"$current\"))\n"
      "    return\n"
      "  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n",
      quoted(fmt::format("{}", fmt::join(names, " "))));
  for (const DeclaredCommand& command : program.commands) {
    std::vector<std::string> options;
    std::vector<std::string> positional;
    bool takes_files = false;
    std::string cases;
    for (const DeclaredOption& option : command.options) {
      if (option.positional) {
        const auto words = words_of(option);
        positional.insert(positional.end(), words.begin(), words.end());
        takes_files = takes_files || option.choices.empty();
        continue;
      }
      options.insert(options.end(), option.names.begin(), option.names.end());
      if (option.value.empty()) continue;
      cases += fmt::format("        {}) {} ;;\n", fmt::join(option.names, "|"),
                           place(words_of(option), option.choices.empty()));
    }
    text += fmt::format(
        "    {})\n"
        "      case $before in\n{}"
        "        *) {} ;;\n"
        "      esac\n"
        "      [[ $current != -* ]] || {{ {}; }}\n"
        "      ;;\n",
        command.name, cases, place(positional, takes_files), place(options, false));
  }
  return text +
         "  esac\n"
         "  while IFS= read -r word; do COMPREPLY+=(\"$word\"); done < <(\n"
         "    compgen -W \"$words\" -- \"$current\"\n"
         "    ((files == 0)) || compgen -f -- \"$current\")\n"
         "}\n";
}

}  // namespace

const std::vector<std::string>& shell_names() {
  static const std::vector<std::string> names = {"bash", "zsh"};
  return names;
}

std::string completion(const DeclaredProgram& program, const std::string& shell) {
  if (shell == "bash") return bash(program) + "complete -o filenames -F _armtune armtune\n";
  if (shell == "zsh") {
    // zsh runs this file as the first call of the completion function. Its last line therefore completes the
    // words of that call.
    return "#compdef armtune\nautoload -U +X bashcompinit && bashcompinit\n" + bash(program) +
           "complete -o filenames -F _armtune armtune\n_bash_complete -o filenames -F _armtune\n";
  }
  throw InputError(
      fmt::format("shell '{}' is not supported; choose one of: {}", shell, fmt::join(shell_names(), ", ")));
}

}  // namespace armtune::internal::cli
