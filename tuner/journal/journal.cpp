#include "tuner/journal/journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"
#include "tuner/journal/journal_lines.hpp"
#include "tuner/run/input_copies.hpp"

namespace armtune::internal {
namespace {

constexpr std::string_view kFormat = "armtune journal 1";
constexpr std::string_view kHeaderEnd = "records";
/// For each time budget, the kind of the record which says that the budget is used up.
constexpr std::array<std::pair<Minutes, std::string_view>, 5> kTimeUp = {
    {{Minutes::kRun, "time-up"},
     {Minutes::kSearch, "search-time-up"},
     {Minutes::kGlobal, "global-time-up"},
     {Minutes::kLocal, "local-time-up"},
     {Minutes::kFinal, "final-time-up"}}};

std::optional<Minutes> minutes_of(std::string_view kind) {
  for (const auto& [minutes, name] : kTimeUp) {
    if (name == kind) return minutes;
  }
  return {};
}

std::string_view row_of(Minutes minutes) {
  return kTimeUp[static_cast<std::size_t>(minutes)].second;
}

/// Removes the word before the first tab, and the tab, from `rest`. Returns the word.
std::string_view first_word(std::string_view& rest) {
  const std::size_t tab = rest.find('\t');
  const std::string_view word = rest.substr(0, tab);
  rest = tab == std::string_view::npos ? std::string_view() : rest.substr(tab + 1);
  return word;
}

std::uint64_t number_in(std::string_view text) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  if (text.empty() || std::from_chars(text.data(), end, number).ptr != end) {
    throw std::invalid_argument(fmt::format("{} is not a number", shown(text)));
  }
  return number;
}

RunHeader read_header(JournalLines& lines, const std::string& path) {
  RunHeader header;
  bool first = true;
  while (lines.next()) {
    const auto payload = lines.payload();
    if (!payload && first)
      throw InputError(InputPlace{path}, "this is not an armtune journal, or its start is damaged")
          .with_value({}, std::string(kFormat));
    if (!payload) {
      throw InputError(at_line(path, lines.number()),
                       "the header of the journal is damaged, so the run cannot be resumed; start it "
                       "again")
          .with_value({}, "a whole header");
    }
    std::string_view rest = *payload;
    const std::string_view kind = first_word(rest);
    if (first) {
      if (*payload != kFormat) {
        throw InputError(
            InputPlace{path},
            fmt::format("the format is {}, not '{}'; another version of armtune wrote this journal",
                        shown(*payload), kFormat))
            .with_value(std::string(*payload), std::string(kFormat));
      }
      first = false;
    } else if (kind == kHeaderEnd) {
      return header;
    } else if (kind == "argument") {
      header.arguments.push_back(unescaped(rest));
    } else if (kind == "folder") {
      header.working_folder = unescaped(rest);
    } else if (kind == "is") {
      const std::string name = unescaped(first_word(rest));
      header.identity.emplace_back(name, unescaped(rest));
    }
  }
  throw InputError(InputPlace{path},
                   "the header is incomplete, because the run was killed at its start; delete the folder and "
                   "start the run again")
      .with_value({}, "a whole header");
}

}  // namespace

RunHeader read_run_header(const std::string& path) {
  JournalLines lines(path);
  return read_header(lines, path);
}

Journal::Journal(const std::string& path, AppendFile::Open open, double patience)
    : path_(path), file_(path, open, patience) {}

std::unique_ptr<Journal> Journal::begin(const std::string& path, const RunHeader& header) {
  std::string text = checked_line(kFormat);
  for (const std::string& argument : header.arguments) text += checked_line("argument\t" + escaped(argument));
  text += checked_line("folder\t" + escaped(header.working_folder));
  for (const auto& [name, value] : header.identity) {
    text += checked_line("is\t" + escaped(name) + '\t' + escaped(value));
  }
  text += checked_line(kHeaderEnd);
  std::unique_ptr<Journal> journal(new Journal(path, AppendFile::Open::kNew, 0.0));
  try {
    journal->file_.append(text);
  } catch (...) {  // with half a header, the folder could not be used again
    std::remove(path.c_str());
    throw;
  }
  journal->size_ = static_cast<long>(text.size());
  return journal;
}

std::unique_ptr<Journal> Journal::resume(const std::string& path, const RunHeader& now, std::string& warning,
                                         double patience) {
  // The header is read before the file is opened for writing, so that a file that is not a journal is
  // refused.
  read_run_header(path);
  std::unique_ptr<Journal> journal(new Journal(path, AppendFile::Open::kContinue, patience));
  warning = journal->read(now);
  return journal;
}

std::string Journal::read(const RunHeader& now) {
  JournalLines lines(path_);
  const RunHeader was = read_header(lines, path_);
  const std::string folder = std::filesystem::path(path_).parent_path().string();
  const std::string other =
      differences(was, now, [&folder](const std::string& hash) { return copy_of_hash(folder, hash); });
  if (!other.empty()) {
    throw InputError(
        InputPlace{path_},
        fmt::format("the run cannot be resumed, because its inputs have changed: {}. Restore them{}, or "
                    "start a new run with --out",
                    other, where_copies_are(folder)));
  }
  long damaged = 0;  // number of the first damaged line; 0: none yet
  long damaged_place = 0;
  long records = 0;
  const auto refuse = [&] {
    throw InputError(
        at_line(path_, damaged),
        fmt::format("record {} is damaged (its checksum is wrong). A kill is not the cause, because it "
                    "damages only the last record. Restore the file from a backup, or start the run again",
                    records))
        .with_value({}, "a line with the right checksum");
  };
  while (lines.next()) {
    if (damaged != 0) refuse();
    const auto payload = lines.payload();
    if (!payload) {
      damaged = lines.number();
      damaged_place = lines.place();
      continue;
    }
    try {
      take(*payload, lines.place());
    } catch (const std::invalid_argument& e) {
      throw InputError(
          at_line(path_, lines.number()),
          fmt::format("record {}: {}; another version of armtune wrote this record", records, e.what()));
    }
    ++records;
  }
  size_ = lines.place();
  if (damaged == 0) return {};
  file_.truncate(damaged_place);
  const long cut = size_ - damaged_place;
  size_ = damaged_place;
  return fmt::format(
      "{}:{}: the last record is incomplete, as after a kill or a power cut; its {} bytes were removed, and "
      "its work is repeated",
      path_, damaged, cut);
}

void Journal::take(std::string_view payload, long place) {
  std::string_view rest = payload;
  const std::string_view kind = first_word(rest);
  if (kind == "finished") {
    const JournalRecord record = record_from_line(rest);
    if (!places_.emplace(record.number, place).second) {
      throw std::invalid_argument(fmt::format("number {} occurs a second time", record.number));
    }
    seconds_ = std::max(seconds_, record.seconds);
  } else if (const auto minutes = minutes_of(kind)) {
    time_was_up_[*minutes] = number_in(rest);
  } else if (kind == "complete") {
    constexpr std::uint64_t kLargestExitCode = 255;
    const std::uint64_t exit_code = number_in(rest);
    if (exit_code > kLargestExitCode)
      throw std::invalid_argument(fmt::format("{} is not an exit code", exit_code));
    exit_code_ = static_cast<int>(exit_code);
  } else {
    throw std::invalid_argument(fmt::format("unknown kind {}", shown(kind)));
  }
}

std::optional<JournalRecord> Journal::find(std::uint64_t number) const {
  const auto place = places_.find(number);
  if (place == places_.end()) return std::nullopt;
  std::ifstream file(path_, std::ios::binary);
  file.seekg(place->second);
  std::string line;
  std::getline(file, line);
  const auto payload = file.eof() ? std::nullopt : payload_of(line);
  if (!payload) throw InputError(InputPlace{path_}, "the file was changed during the run");
  std::string_view rest = *payload;
  first_word(rest);
  return record_from_line(rest);
}

void Journal::write(const std::string& payload) {
  const std::string line = checked_line(payload);
  try {
    file_.append(line);
  } catch (...) {  // otherwise later lines would follow an incomplete one
    file_.truncate(size_);
    throw;
  }
  size_ += static_cast<long>(line.size());
}

void Journal::append(const JournalRecord& record) {
  const long place = size_;
  write("finished\t" + to_line(record));
  places_.emplace(record.number, place);
  seconds_ = std::max(seconds_, record.seconds);
}

std::optional<std::uint64_t> Journal::time_was_up(Minutes minutes) const {
  const auto found = time_was_up_.find(minutes);
  return found == time_was_up_.end() ? std::nullopt : std::optional(found->second);
}

void Journal::time_is_up(std::uint64_t number, Minutes minutes) {
  write(fmt::format("{}\t{}", row_of(minutes), number));
  time_was_up_[minutes] = number;
}

void Journal::complete(int exit_code) {
  write(fmt::format("complete\t{}", exit_code));
  exit_code_ = exit_code;
}

}  // namespace armtune::internal
