#include "tuner/cli/declared/markdown_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace armtune::cli {
namespace {

/// Text for a cell of a table.
std::string cell_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*' || c == '_') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

std::string value_text(const DeclaredOption& option) {
  if (!option.choices.empty()) return fmt::format("{}", fmt::join(option.choices, ", "));
  const std::string kind = bundled_kind(option);
  return option.value + (option.many ? " ..." : "") +
         (kind.empty() ? "" : fmt::format(", or one of the bundled {}", kind));
}

void add_command(const DeclaredCommand& command, const std::string& usage, std::string& page) {
  page += fmt::format("{}.\n\n```text\n{}\n```\n\n", command.meaning, usage);
  page += "| option | takes | default | |\n|---|---|---|---|\n";
  for (const DeclaredOption& option : command.options) {
    page += fmt::format("| `{}` | {} | {} | {}{} |\n", fmt::join(option.names, "`, `"),
                        cell_text(value_text(option)),
                        option.otherwise == "[]" ? "" : cell_text(option.otherwise),
                        option.required ? "**required**; " : "", cell_text(option.meaning));
  }
  if (!command.footer.empty()) page += fmt::format("\n```text\n{}\n```\n", command.footer);
}

std::string usage_of(const std::string& program, const DeclaredCommand& command) {
  std::string usage = fmt::format("{} {} [options]", program, command.name);
  for (const DeclaredOption& option : command.options) {
    if (!option.positional) continue;
    usage += fmt::format(" {}{}{}{}", option.required ? "" : "[", option.names.front(),
                         option.many ? " ..." : "", option.required ? "" : "]");
  }
  return usage;
}

}  // namespace

std::string markdown_page(const DeclaredProgram& program) {
  std::string page =
      "# Commands\n\nWhat `armtune COMMAND --help` says. Made by `armtune man --markdown`.\n\n| command | "
      "|\n|---|---|\n";
  for (const DeclaredCommand& command : program.commands)
    page += fmt::format("| [{0}](#armtune-{0}) | {1} |\n", command.name, cell_text(command.meaning));
  page += fmt::format("\n{}\n", program.app.footer);
  for (const DeclaredCommand& command : program.commands) {
    page += fmt::format("\n## armtune {}\n\n", command.name);
    add_command(command, usage_of(program.app.name, command), page);
  }
  return page;
}

}  // namespace armtune::cli
