#include "core/robot/xacro.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <mutex>
#include <string_view>
#include <system_error>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "core/robot/child_program.hpp"

namespace armtune::internal {
namespace {

constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
constexpr std::string_view kDigits = "0123456789";

struct Expansions {
  XacroOptions options;
  std::map<std::string, std::string> texts;  ///< by absolute path of the xacro file
};

std::unique_ptr<Expansions> expansions;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
std::mutex expansions_mutex;             // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

bool consists_of(std::string_view text, const std::string& characters) {
  return text.find_first_not_of(characters) == std::string_view::npos;
}

/// True for NAME:=VALUE. An option of xacro, such as `-o FILE`, is not.
bool is_xacro_argument(const std::string& text) {
  const std::size_t assign = text.find(":=");
  if (assign == std::string::npos || assign == 0) return false;
  const std::string name = text.substr(0, assign);
  return consists_of(name.substr(0, 1), std::string(kLetters)) &&
         consists_of(name, fmt::format("{}{}", kLetters, kDigits));
}

/// Returns the command in the form that a shell reads back as these words.
std::string shell_command(const std::vector<std::string>& words) {
  const std::string plain = fmt::format("{}{}./:=+,-", kLetters, kDigits);
  std::string command;
  for (const std::string& word : words) {
    if (!command.empty()) command += ' ';
    if (!word.empty() && consists_of(word, plain)) {
      command += word;
      continue;
    }
    command += '\'';
    for (const char c : word) command += c == '\'' ? std::string("'\\''") : std::string(1, c);
    command += '\'';
  }
  return command;
}

/// Returns the text on one line of at most 300 characters.
std::string on_one_line(const std::string& text) {
  constexpr std::size_t kMost = 300;
  std::string line;
  for (const char c : text) {
    if (line.size() == kMost) return line + " ...";
    const bool is_break = c == '\n' || c == '\r';
    if (!is_break || (!line.empty() && !line.ends_with("; "))) line += is_break ? "; " : std::string(1, c);
  }
  while (line.ends_with(' ') || line.ends_with(';')) line.pop_back();
  return line;
}

[[noreturn]] void refuse_expansion(const std::string& path, const std::string& why) {
  throw InputError(InputPlace{path}, why);
}

/// Throws InputError unless xacro ended as it should.
void check_xacro(const std::string& path, const ChildOutcome& outcome, const ChildLimits& limits) {
  const std::string said = on_one_line(outcome.err);
  const std::string because = said.empty() ? std::string(" without a message") : ": " + said;
  const std::size_t megabytes = limits.bytes >> 20U;
  switch (outcome.end) {
    case ChildEnd::kExited:
      break;
    case ChildEnd::kKilled:
      refuse_expansion(path, "xacro was killed by a signal" + because);
    case ChildEnd::kTooSlow:
      throw InputError(InputPlace{path},
                       fmt::format("xacro did not end within {:g} s and was stopped; expand "
                                   "the file yourself",
                                   limits.time))
          .with_value({}, fmt::format("{:g} s", limits.time));
    case ChildEnd::kTooLarge:
      throw InputError(InputPlace{path},
                       fmt::format("xacro wrote more than {} MB and was stopped; the URDF of "
                                   "an arm is far smaller",
                                   megabytes))
          .with_value({}, fmt::format("at most {} MB", megabytes));
    case ChildEnd::kInterrupted:
      refuse_expansion(path, "expanding it with xacro was interrupted");
    case ChildEnd::kNotStarted:
      refuse_expansion(path,
                       "xacro could not be started: " + std::generic_category().message(outcome.exit_code));
  }
  if (outcome.exit_code != 0)
    refuse_expansion(path, fmt::format("xacro failed with exit code {}{}", outcome.exit_code, because));
  if (outcome.out.empty()) refuse_expansion(path, "xacro wrote no URDF" + because);
}

std::string run_xacro(const std::string& path, std::size_t most, const XacroOptions& options) {
  const auto program = program_in_path("xacro");
  if (!program) {
    refuse_expansion(
        path,
        "there is no program 'xacro' in the folders of PATH; source your ROS workspace, or install "
        "it with 'pip install xacro'");
  }
  std::vector<std::string> words = {*program, absolute_path(path)};
  words.insert(words.end(), options.arguments.begin(), options.arguments.end());
  if (options.starting) options.starting(shell_command(words));
  const ChildLimits limits{options.time_limit, most};
  ChildOutcome outcome = run_child(words, limits);
  check_xacro(path, outcome, limits);
  return std::move(outcome.out);
}

}  // namespace

XacroExpansion::XacroExpansion(XacroOptions options) {
  for (const std::string& argument : options.arguments) {
    if (!is_xacro_argument(argument)) {
      throw InputError(InputPlace{.key = "xacro argument"},
                       InputFault{.problem = fmt::format("'{}' is not an argument of a xacro file", argument),
                                  .value = argument,
                                  .limit = "NAME:=VALUE, such as ur_type:=ur5e"});
    }
  }
  const std::lock_guard lock(expansions_mutex);
  expansions = std::make_unique<Expansions>(Expansions{std::move(options), {}});
}

XacroExpansion::~XacroExpansion() {
  const std::lock_guard lock(expansions_mutex);
  expansions.reset();
}

std::optional<std::string> expanded_xacro(const std::string& path, std::size_t most) {
  const std::lock_guard lock(expansions_mutex);
  if (!expansions) return std::nullopt;
  const std::string key = absolute_path(path);
  const auto known = expansions->texts.find(key);
  if (known != expansions->texts.end()) return known->second;
  std::string text = run_xacro(path, most, expansions->options);
  return expansions->texts.emplace(key, std::move(text)).first->second;
}

}  // namespace armtune::internal
