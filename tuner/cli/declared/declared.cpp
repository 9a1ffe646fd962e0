#include "tuner/cli/declared/declared.hpp"

#include <CLI/CLI.hpp>
#include <map>
#include <sstream>

namespace armtune::internal::cli {
namespace {

/// Returns an option with the type of its value and the allowed words, from CLI11's type names, such as
/// "TEXT:{a,b}" and "TEXT:INT in [1 - 9]".
DeclaredOption with_type(const CLI::Option& option) {
  DeclaredOption made;
  std::string type = option.get_items_expected_max() == 0 ? std::string() : option.get_type_name();
  if (const auto open = type.find('{'); open != std::string::npos) {
    std::istringstream words(type.substr(open + 1, type.find('}', open) - open - 1));
    for (std::string word; std::getline(words, word, ',');) made.choices.push_back(word);
    type.resize(type.find(':'));
  }
  // For a number with a range, the text after the colon has the type and the range.
  if (const auto colon = type.find(':'); colon != std::string::npos) type = type.substr(colon + 1);
  made.value = type;
  return made;
}

DeclaredOption declared_option(const CLI::Option& option) {
  DeclaredOption made = with_type(option);
  made.positional = option.get_positional();
  if (made.positional) {
    made.names = {option.get_single_name()};
  } else {
    for (const std::string& name : option.get_snames()) made.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) made.names.push_back("--" + name);
  }
  made.otherwise = default_of(option);
  made.meaning = option.get_description();
  made.required = option.get_required();
  made.many = option.get_items_expected_max() > 1;
  return made;
}

DeclaredCommand declared_command(const CLI::App& app, const std::string& name) {
  DeclaredCommand made{name, app.get_description(), {}, app.get_footer()};
  for (const CLI::Option* option : app.get_options()) made.options.push_back(declared_option(*option));
  return made;
}

}  // namespace

DeclaredProgram declared(const CLI::App& app, const std::string& name) {
  DeclaredProgram program{declared_command(app, name), {}};
  // Commands inherit the program's footer, which is removed from them below.
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    program.commands.push_back(declared_command(*command, command->get_name()));
  for (DeclaredCommand& command : program.commands) {
    if (command.footer.ends_with(program.app.footer))
      command.footer.resize(command.footer.size() - program.app.footer.size());
    while (command.footer.ends_with('\n')) command.footer.pop_back();
  }
  return program;
}

std::string default_of(const CLI::Option& option) {
  // If an option may be given without a value, CLI11's default is the value that it then has, not the value
  // without the option.
  const bool value_is_optional = option.get_items_expected_min() == 0 && option.get_items_expected_max() > 0;
  return value_is_optional ? std::string() : option.get_default_str();
}

std::string bundled_kind(const DeclaredOption& option) {
  static const std::map<std::string, std::string> kinds = {
      {"STUDY", "studies"},        {"SCENARIO", "scenarios"},
      {"--scenario", "scenarios"}, {"--scenarios", "scenarios"},
      {"ROBOT", "robots"},         {"--robot", "robots"},
      {"RUN_OR_GAINS", "gains"},   {"--gains", "gains"},
      {"--theta", "theta"},        {"TASK", "tasks"}};
  for (const std::string& name : option.names) {
    if (const auto found = kinds.find(name); found != kinds.end() && !option.value.empty())
      return found->second;
  }
  return {};
}

}  // namespace armtune::internal::cli
