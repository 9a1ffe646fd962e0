#include "tuner/cli/declared/man_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace armtune::internal::cli {
namespace {

/// Returns the text with escapes for groff: for backslashes, for hyphens (which groff would replace by
/// typographic ones), and for dots and quotes at the start of a line.
std::string escaped(const std::string& text) {
  std::string out;
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
    begins = c == '\n';
  }
  return out;
}

/// Returns the text with its own line breaks, because tables and examples are laid out for a terminal.
std::string as_it_stands(const std::string& text) {
  return fmt::format(".nf\n{}\n.fi\n", escaped(text));
}

std::string synopsis(const DeclaredOption& option) {
  std::string text = fmt::format("\\fB{}\\fR", escaped(fmt::format("{}", fmt::join(option.names, ", "))));
  if (option.positional) return text + (option.many ? " ..." : "");
  if (!option.choices.empty()) return text + " " + escaped(fmt::format("{}", fmt::join(option.choices, "|")));
  if (!option.value.empty())
    text += fmt::format(" \\fI{}\\fR{}", escaped(option.value), option.many ? " ..." : "");
  return text;
}

void add_options(const DeclaredCommand& command, std::string& page) {
  for (const DeclaredOption& option : command.options) {
    page += fmt::format(".TP\n{}\n{}{}\n", synopsis(option), escaped(option.meaning),
                        option.otherwise.empty() || option.otherwise == "[]"
                            ? ""
                            : ". Default: " + escaped(option.otherwise) + ".");
  }
}

}  // namespace

std::string man_page(const DeclaredProgram& program, const std::string& version) {
  const std::string& name = program.app.name;
  std::string page = fmt::format(".TH {} 1 \"\" \"{}\" \"User Commands\"\n.SH NAME\n{} \\- ", escaped(name),
                                 escaped(version), escaped(name));
  // The title is the description up to its first colon. The text after its first paragraph is an example.
  std::istringstream paragraphs(program.app.meaning);
  std::string title;
  std::getline(paragraphs, title);
  const auto colon = title.find(':');
  page += escaped(title.substr(0, colon)) + "\n.SH SYNOPSIS\n";
  for (const DeclaredCommand& command : program.commands) {
    page += fmt::format(".B {} {}\n[options]", escaped(name), escaped(command.name));
    for (const DeclaredOption& option : command.options) {
      if (!option.positional) continue;
      page += fmt::format(" {0}\\fI{1}\\fR{3}{2}", option.required ? "" : "[", escaped(option.names.front()),
                          option.required ? "" : "]", option.many ? " ..." : "");
    }
    page += "\n.br\n";
  }
  const auto paragraph = std::min(program.app.meaning.find("\n\n"), program.app.meaning.size());
  page +=
      fmt::format(".SH DESCRIPTION\n{}\n{}.SH OPTIONS\n", escaped(program.app.meaning.substr(0, paragraph)),
                  as_it_stands(program.app.meaning.substr(paragraph)));
  add_options(program.app, page);
  page += ".SH COMMANDS\n";
  for (const DeclaredCommand& command : program.commands) {
    page += fmt::format(".SS {}\n{}\n", escaped(command.name), escaped(command.meaning));
    add_options(command, page);
    if (!command.footer.empty()) page += ".PP\n" + as_it_stands(command.footer);
  }
  return page + ".SH EXIT STATUS\n" + escaped(program.app.footer) + "\n";
}

}  // namespace armtune::internal::cli
