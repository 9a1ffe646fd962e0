#include "tuner/cli/declared/short_help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>
#include <sstream>

#include "tuner/cli/declared/declared.hpp"

namespace armtune::internal::cli {
namespace {

constexpr const char* kPlainHeading = "Options";  ///< CLI11's heading for options without another
constexpr const char* kFurther = "Further options";
constexpr double kAnyNumber = 1e8;  ///< help does not show upper limits of this size or above
constexpr std::size_t kWidth = 80;  ///< longest line of a description, without the option's name

/// Returns the text with line breaks, so that no line is longer than kWidth unless it is a single word.
std::string wrapped(const std::string& text) {
  std::istringstream words(text);
  std::string out;
  std::size_t used = 0;
  for (std::string word; words >> word;) {
    const bool fits = used + 1 + word.size() <= kWidth;
    if (!out.empty()) out += fits ? ' ' : '\n';
    used = out.empty() || !fits ? word.size() : used + 1 + word.size();
    out += word;
  }
  return out;
}

/// The type of an option's value and its allowed values, from CLI11's type name "INT:INT in [1 - 9]".
struct ValueType {
  std::string kind;    ///< "INT"; empty: a flag
  std::string limits;  ///< "1 to 9"; empty: none
};

ValueType value_type(const CLI::Option& option) {
  if (option.get_type_size() == 0) return {};
  const std::string name = option.get_type_name();
  const std::size_t colon = std::min(name.find(':'), name.size());
  ValueType type{name.substr(0, colon), name.substr(std::min(colon + 1, name.size()))};
  if (type.kind == "UINT") type.kind = "INT";
  if (type.kind == "FLOAT") type.kind = "NUMBER";
  std::string& limits = type.limits;
  const std::size_t open = limits.find('[');
  const std::size_t dash = limits.find(" - ");
  if (open != std::string::npos && dash != std::string::npos && limits.ends_with(']')) {
    const std::string least = limits.substr(open + 1, dash - open - 1);
    const std::string most = limits.substr(dash + 3, limits.size() - dash - 4);
    limits = std::stod(most) < kAnyNumber ? fmt::format("{} to {}", least, most) : "at least " + least;
  } else if (limits.starts_with('{') && limits.ends_with('}')) {
    std::string choices;
    for (const char c : limits.substr(1, limits.size() - 2)) choices += c == ',' ? ", " : std::string(1, c);
    limits = "one of: " + choices;
  } else {
    limits = limits == "POSITIVE" ? "above 0" : "";
  }
  return type;
}

std::string names_of(const std::set<CLI::Option*>& options) {
  std::string names;
  for (const CLI::Option* option : options) names += (names.empty() ? "" : ", ") + option->get_name();
  return names;
}

/// Returns the conditions that help shows in brackets after the description of an option.
std::vector<std::string> conditions(const CLI::Option& option) {
  std::vector<std::string> all;
  if (option.get_required()) all.emplace_back("required");
  if (const std::string limits = value_type(option).limits; !limits.empty()) all.push_back(limits);
  if (const std::string value = default_of(option); !value.empty()) all.push_back("default: " + value);
  if (!option.get_needs().empty()) all.push_back("only with " + names_of(option.get_needs()));
  if (!option.get_excludes().empty()) all.push_back("not with " + names_of(option.get_excludes()));
  return all;
}

const ShortHelp* short_help_of(const std::string& command) {
  const auto& all = short_helps();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const ShortHelp& help) { return help.command == command; });
  return found == all.end() ? nullptr : &*found;
}

bool is_help(const CLI::App& command, const CLI::Option* option) {
  return option == command.get_help_ptr() || option == command.get_help_all_ptr();
}

bool is_shown(const ShortHelp& help, const CLI::Option& option) {
  return std::any_of(help.groups.begin(), help.groups.end(), [&](const OptionGroup& group) {
    return std::any_of(group.options.begin(), group.options.end(),
                       [&](const std::string& name) { return option.check_name(name); });
  });
}

class HelpFormatter final : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    const ShortHelp* help = short_help_of(app->get_name());
    if (help == nullptr || mode == CLI::AppFormatMode::Sub) return CLI::Formatter::make_help(app, name, mode);
    return make_description(app) + make_usage(app, name) + make_positionals(app) +
           groups_text(*app, *help, mode == CLI::AppFormatMode::All) + "\n" + make_footer(app);
  }

  /// Returns the command's footer, and behind it the program's, which gives the exit codes. CLI11 drops that
  /// where a command has a text of its own. Some footers read files, so none is asked for before it is shown.
  std::string make_footer(const CLI::App* app) const override {
    const CLI::App* program = app;
    while (program->get_parent() != nullptr) program = program->get_parent();
    const std::string codes = program->get_footer();
    const std::string text = app->get_footer();
    return (text.ends_with(codes) ? text : text + "\n\n" + codes) + "\n";
  }

  /// Returns the name without the suffix that CLI11 adds to flags that set false, as in "--robust{false}".
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
    const std::string name = CLI::Formatter::make_option_name(option, is_positional);
    return name.substr(0, name.find('{'));
  }

  /// Returns only the type of the value. CLI11 would also put limits, default and other options between name
  /// and description.
  std::string make_option_opts(const CLI::Option* option) const override {
    if (!option->get_option_text().empty()) return " " + option->get_option_text();
    const std::string kind = value_type(*option).kind;
    if (kind.empty()) return {};
    const bool many = option->get_expected_max() == CLI::detail::expected_max_vector_size;
    return " " + kind + (many ? " ..." : "");
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    const std::string text = option->get_description();
    const std::vector<std::string> more = conditions(*option);
    if (more.empty()) return wrapped(text);
    return wrapped(fmt::format("{}{}({})", text, text.empty() ? "" : " ", fmt::join(more, "; ")));
  }

 private:
  std::string groups_text(const CLI::App& app, const ShortHelp& help, bool all) const {
    std::string text;
    std::size_t left_out = 0;
    for (const std::string& heading : headings(app, help)) {
      const auto options = app.get_options([&](const CLI::Option* option) {
        if (option->get_group() != heading || !option->nonpositional()) return false;
        const bool shown = all || heading == kPlainHeading || is_shown(help, *option);
        left_out += shown ? 0 : 1;
        return shown;
      });
      if (!options.empty()) text += make_group(heading, false, options);
    }
    if (left_out > 0)
      text += fmt::format("\n{} more options: armtune {} --help-all\n", left_out, app.get_name());
    return text;
  }

  /// Returns the headings: first those of the short help, in its order, then all others.
  static std::vector<std::string> headings(const CLI::App& app, const ShortHelp& help) {
    std::vector<std::string> headings = {kPlainHeading};
    const auto add = [&headings](const std::string& heading) {
      if (std::find(headings.begin(), headings.end(), heading) == headings.end()) headings.push_back(heading);
    };
    for (const OptionGroup& group : help.groups) add(group.heading);
    for (const std::string& heading : app.get_groups()) {
      if (!heading.empty()) add(heading);
    }
    return headings;
  }
};

}  // namespace

const std::vector<ShortHelp>& short_helps() {
  static const std::vector<ShortHelp> all = {
      {"init",
       {{"What is tuned", {"--robot", "--controllers", "--node", "--distro", "--controller", "--rate"}},
        {"Search", {"--max-stiffness"}},
        {"Motions", {"--trajectory", "--degrees"}},
        {"Results", {"--out"}}}},
      {"simulate",
       {{"What is simulated", {"--gains", "--theta", "--endurance", "--yardstick"}},
        {"Results", {"--out"}},
        {"Speed", {"--engine", "--workers"}}}},
      {"tune",
       {{"What is tuned", {"--robot", "--controllers", "--trajectory", "--controller", "--warm-start"}},
        {"Search", {"--max-evaluations", "--seed"}},
        {"Results", {"--out", "--resume"}},
        {"Speed", {"--workers"}}}},
      {"pareto",
       {{"Pareto front", {"--criteria", "--levels", "--controller"}},
        {"Search", {"--max-evaluations", "--seed"}},
        {"Results", {"--out", "--resume"}},
        {"Speed", {"--workers"}}}},
      {"robustness",
       {{"What is simulated", {"--scenarios", "--samples", "--distribution", "--limit"}},
        {"Uncertainty (uniform)", {"--mass", "--friction", "--payload"}},
        {"Results", {"--out", "--resume"}},
        {"Speed", {"--workers"}}}},
      {"compare",
       {{"What is compared", {"--scenarios", "--endurance", "--gains", "--robot"}},
        {"Results", {"--out", "--all-metrics"}},
        {"Speed", {"--workers"}}}},
      {"excite",
       {{"Motion", {"--center", "--amplitude", "--margin", "--min-height", "--frequency", "--duration"}},
        {"Simulated logs", {"--scenario", "--torque-noise"}},
        {"Results", {"--out"}}}},
      {"identify",
       {{"Logs", {"--columns", "--cutoff", "--torque-delay"}},
        {"Fit", {"--robot", "--robust", "--fit-all", "--accept"}},
        {"Results", {"--out"}}}},
      {"validate",
       {{"Log", {"--topic", "--columns"}},
        {"What is compared", {"--robot", "--commands", "--controllers", "--gains"}},
        {"Results", {"--out"}}}},
      {"calibrate",
       {{"Logs", {"--commands", "--topic", "--columns"}}, {"Fit", {"--robot"}}, {"Results", {"--out"}}}},
  };
  return all;
}

std::shared_ptr<CLI::FormatterBase> help_formatter() {
  return std::make_shared<HelpFormatter>();
}

void group_options(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    const ShortHelp* help = short_help_of(command->get_name());
    if (help == nullptr) continue;
    for (const OptionGroup& group : help->groups) {
      for (const std::string& name : group.options) {
        if (CLI::Option* option = command->get_option_no_throw(name)) option->group(group.heading);
      }
    }
    for (CLI::Option* option : command->get_options()) {
      if (option->nonpositional() && option->get_group() == kPlainHeading && !is_help(*command, option))
        option->group(kFurther);
    }
  }
}

}  // namespace armtune::internal::cli
