#include "tuner/cli/resume.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/cli/shell_words.hpp"
#include "tuner/ranks/transport.hpp"

namespace armtune::internal::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kResume = "--resume";
/// Options that do not affect the results. They may change when a run is resumed.
constexpr const char* kFree[] = {"--workers", "--rollout-deadline"};
constexpr const char* kLive = "--live";  ///< another such option, without a value

/// Removes an option with its value ("--option value" or "--option=value") from the words. Returns the value,
/// or nothing if the words do not contain the option.
std::optional<std::string> cut(std::vector<std::string>& words, const std::string& option) {
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (word->starts_with(option + "=")) {
      const std::string value = word->substr(option.size() + 1);
      words.erase(word);
      return value;
    }
    if (*word == option && word + 1 != words.end()) {
      const std::string value = *(word + 1);
      words.erase(word, word + 2);
      return value;
    }
  }
  return std::nullopt;
}

}  // namespace

void add_run_options(CLI::App& command, const std::string& out_help, const std::string& out_default,
                     RunPlace& place, int& workers, double& deadline) {
  command.add_option("--out", place.folder, out_help)->default_str(out_default);
  command.add_option_function<std::string>(
      kResume,
      [&place](const std::string& folder) {
        place = {folder, true};
      },
      "resume the killed or interrupted run in this folder, with the same results as without the "
      "interruption. Of the run's options, only --workers, --rollout-deadline and, with tune, --live can be "
      "changed");
  command.add_option("--workers", workers, kWorkersHelp)
      ->check(CLI::Range(1, 1024))
      ->default_str(kWorkersDefault);
  command.add_option("--rollout-deadline", deadline, kDeadlineHelp)
      ->check(CLI::PositiveNumber)
      ->default_str(kDeadlineDefault);
}

std::string repeating_command(std::vector<std::string> words) {
  cut(words, kResume);
  return quoted_command(words);
}

std::vector<std::string> resumed_arguments(std::vector<std::string> words) {
  const auto folder = cut(words, kResume);
  if (!folder) return words;
  const RunHeader begun = read_run_header(journal_in(*folder));
  if (begun.arguments.empty()) {
    throw InputError(*folder +
                     ": this run was started by a program through armtune's library; resume it with that "
                     "program");
  }
  std::vector<std::string> all = {words.front()};
  all.insert(all.end(), begun.arguments.begin(), begun.arguments.end());
  all.insert(all.end(), {kResume, absolute_path(*folder)});
  for (const char* option : kFree) {
    if (const auto value = cut(words, option)) all.insert(all.end(), {option, *value});
  }
  if (std::erase(words, kLive) > 0) all.emplace_back(kLive);
  if (words.size() < 2 || words[1] != begun.arguments.front()) {
    throw InputError(fmt::format("{} was started by 'armtune {}'; resume it with: {} {} --resume {}", *folder,
                                 fmt::join(begun.arguments, " "), program_name(), begun.arguments.front(),
                                 *folder));
  }
  if (words.size() > 2) {
    throw InputError(
        fmt::format("--resume continues {} with the command that started it ('armtune {}'); '{}' cannot be "
                    "changed, only {} and {} can",
                    *folder, fmt::join(begun.arguments, " "), words[2], fmt::join(kFree, ", "), kLive));
  }
  std::error_code gone;
  fs::current_path(begun.working_folder, gone);
  if (gone && rank_place().rank == 0) {
    print_warning(fmt::format(
        "{}: this folder, in which the run was started, no longer exists; relative paths in the command line "
        "of the run now start in the current folder",
        begun.working_folder));
  }
  return all;
}

SessionContext session_context() {
  Invocation invocation{{command_words().begin() + 1, command_words().end()}, command_line()};
  cut(invocation.words, "--out");
  for (const char* option : kFree) cut(invocation.words, option);
  return {stop_requested(), std::move(invocation)};
}

}  // namespace armtune::internal::cli
