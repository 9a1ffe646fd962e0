#include "tuner/cli/resume.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "core/common/error.hpp"
#include "core/common/file_path.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/warm_arguments.hpp"
#include "tuner/ranks/transport.hpp"
#include "tuner/run/arithmetic.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kResume = "--resume";
constexpr const char* kJournal = "journal.txt";
/// Options that results do not depend on, and that a resumed run may be given anew.
constexpr const char* kFree[] = {"--workers", "--rollout-deadline"};
constexpr const char* kLive = "--live";  ///< another one, without a value

/// An option and its value cut out of the words, in either spelling; nothing if it is not among them.
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

/// A word as a shell takes it for one.
std::string shell_word(const std::string& word) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// Removes what a run that has just begun has in its folder but for its journal, and the folder if nothing
/// else is in it: a journal would be another run's.
void discard_folder(const std::string& folder) {
  std::error_code ignored;
  const fs::path warm = fs::path(folder) / kWarmGains;
  fs::remove(warm, ignored);
  fs::remove(warm.parent_path(), ignored);
  fs::remove_all(fs::path(folder) / kInputCopies, ignored);
  fs::remove(folder, ignored);
}

/// Path of a run's journal; where there is none, the name that it would have.
std::string journal_in(const std::string& folder) {
  return find_run_file(folder, kJournal).value_or(folder + "/" + kJournal);
}

}  // namespace

std::string quoted_command(const std::vector<std::string>& words) {
  std::string text = "armtune";
  for (std::size_t i = 1; i < words.size(); ++i) text += ' ' + shell_word(words[i]);
  return text;
}

std::string repeating_command(std::vector<std::string> words) {
  cut(words, kResume);
  return quoted_command(words);
}

std::vector<std::string> resumed_arguments(std::vector<std::string> words) {
  const auto folder = cut(words, kResume);
  if (!folder) return words;
  const RunHeader begun = read_run_header(journal_in(*folder));
  std::vector<std::string> all = {words.front()};
  all.insert(all.end(), begun.arguments.begin(), begun.arguments.end());
  all.insert(all.end(), {kResume, absolute_path(*folder)});
  for (const char* option : kFree) {
    if (const auto value = cut(words, option)) all.insert(all.end(), {option, *value});
  }
  if (std::erase(words, kLive) > 0) all.emplace_back(kLive);
  if (words.size() < 2 || begun.arguments.empty() || words[1] != begun.arguments.front()) {
    throw InputError(fmt::format("{} was begun by 'armtune {}'; resume it with: {} {} --resume {}", *folder,
                                 fmt::join(begun.arguments, " "), program_name(),
                                 begun.arguments.empty() ? "" : begun.arguments.front(), *folder));
  }
  if (words.size() > 2) {
    throw InputError(
        fmt::format("--resume goes on with what {} was begun with ('armtune {}'); '{}' cannot be changed, "
                    "only {} and {}",
                    *folder, fmt::join(begun.arguments, " "), words[2], fmt::join(kFree, ", "), kLive));
  }
  std::error_code gone;
  fs::current_path(begun.working_folder, gone);
  if (gone && rank_place().rank == 0) {
    fmt::print(stderr,
               "armtune: warning: {}, where the run was begun, is not there; relative paths of its command "
               "line begin "
               "here instead\n",
               begun.working_folder);
  }
  return all;
}

std::vector<std::pair<std::string, std::string>> identity_of(const Study& study) {
  const std::string warm = study.warm ? kWarmGains : "";
  std::vector<std::pair<std::string, std::string>> identity = {
      {"seed", fmt::format("{}", study.solver.seed)},
      {"study", study_yaml(study, "start/gains.yaml", warm)},
      {"start gains", gains_yaml(study.space.start, {})}};
  if (study.warm) identity.emplace_back("warm gains", gains_yaml(study.warm->gains, {}));
  return identity;
}

std::vector<std::string> inputs_of(const Study& study) {
  std::vector<std::string> inputs;
  add_inputs(study.scenarios, inputs);
  return inputs;
}

RunHeader run_header(std::vector<std::pair<std::string, std::string>> identity,
                     const std::vector<std::string>& inputs) {
  RunHeader header;
  header.arguments = command_words();
  header.arguments.erase(header.arguments.begin());
  cut(header.arguments, "--out");
  for (const char* option : kFree) cut(header.arguments, option);
  header.working_folder = absolute_path(".");
  header.identity = std::move(identity);
  for (auto& version : versions()) header.identity.push_back(std::move(version));
  header.identity.emplace_back("arithmetic", arithmetic().fingerprint);
  header.identity.emplace_back(RunHeader::kProgram, hash_of_file("/proc/self/exe"));
  for (auto& input : hashes(inputs)) header.identity.push_back(std::move(input));
  return header;
}

std::unique_ptr<Journal> open_journal(const std::string& folder, const std::string& resume,
                                      const RunHeader& header, const std::vector<std::string>& inputs) {
  if (resume.empty()) {
    std::unique_ptr<Journal> journal;
    try {
      journal = Journal::begin(folder + "/" + kJournal, header);
      keep_inputs(folder, inputs);
    } catch (...) {  // it is not to be in the way of another try
      journal ? discard_run(folder) : discard_folder(folder);
      throw;
    }
    return journal;
  }
  std::string warning;
  constexpr double kPatience = 10.0;  // ranks of a killed run are gone by then
  auto journal = Journal::resume(journal_in(folder), header, warning, kPatience);
  if (!warning.empty()) fmt::print(stderr, "armtune: warning: {}\n", warning);
  if (journal->exit_code()) return journal;
  refuse_links(folder);
  keep_inputs(folder, inputs);
  return journal;
}

void tell_how_to_go_on(const std::string& command, const std::string& folder) {
  std::error_code ignored;
  if (!std::filesystem::exists(folder + "/" + kJournal, ignored)) return;
  fmt::print(stderr, "what was finished is in {}; once the cause is gone, go on: {} {} --resume {}\n", folder,
             program_name(), command, folder);
}

void discard_run(const std::string& folder) {
  std::error_code ignored;
  fs::remove(folder + "/" + kJournal, ignored);
  discard_folder(folder);
}

}  // namespace armtune::cli
