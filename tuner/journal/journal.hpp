#pragma once
// Writes and reads the journal of a run, journal.txt. It keeps every finished evaluation, so that a run that
// was killed can be resumed where it stopped. Each line begins with a checksum (16 hexadecimal digits) of the
// rest of the line.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "tuner/journal/record.hpp"
#include "tuner/journal/run_header.hpp"
#include "tuner/run/append_file.hpp"

namespace armtune::internal {

/// The time budgets of a run. kRun is the budget of the whole run. kSearch ends earlier, so that time is left
/// for the last steps after a search. kGlobal ends earlier still: it limits the global search, so that time
/// is left for the local searches. kLocal limits these, so that time is left for a final phase, and kFinal
/// limits the final phase.
enum class Minutes { kRun, kSearch, kGlobal, kLocal, kFinal };

class Journal {
 public:
  /// Begins a journal and writes its header to disk. Throws InputError if the file exists or cannot be made.
  static std::unique_ptr<Journal> begin(const std::string& path, const RunHeader& header);

  /// Opens a journal to continue it. If the run was killed while it wrote, the incomplete last line is cut
  /// off, and `warning` reports this. now: header of the resumed run. patience: how long to wait if another
  /// process has the journal open for writing [s]. Throws InputError if the file cannot be read, if a line
  /// is damaged (naming the record), if another process is writing the file, or if `now` differs from the
  /// header in the journal (naming what differs).
  static std::unique_ptr<Journal> resume(const std::string& path, const RunHeader& now, std::string& warning,
                                         double patience = 0.0);

  /// Returns the record with this number if it exists. Throws InputError if the file was changed meanwhile.
  std::optional<JournalRecord> find(std::uint64_t number) const;
  std::size_t records() const { return places_.size(); }
  /// Appends a record and writes it to disk. Throws FailedError if the disk refuses the record.
  void append(const JournalRecord& record);

  /// Returns the number of the evaluation that was next when this time budget was used up; nothing if the
  /// budget was not used up.
  std::optional<std::uint64_t> time_was_up(Minutes minutes = Minutes::kRun) const;
  void time_is_up(std::uint64_t number, Minutes minutes = Minutes::kRun);

  /// Returns the exit code of a run whose results are all written; nothing for an incomplete run.
  std::optional<int> exit_code() const { return exit_code_; }
  void complete(int exit_code);

  /// Returns the wall time of the run at its last record [s].
  double seconds() const { return seconds_; }

 private:
  Journal(const std::string& path, AppendFile::Open open, double patience);
  /// Reads the lines after the header. Returns a warning, or an empty text.
  std::string read(const RunHeader& now);
  void take(std::string_view payload, long place);
  void write(const std::string& payload);

  std::string path_;
  AppendFile file_;
  long size_ = 0;                         ///< size of the file [bytes]
  std::map<std::uint64_t, long> places_;  ///< offset of each record's line [bytes], by number of the record
  std::map<Minutes, std::uint64_t> time_was_up_;
  std::optional<int> exit_code_;
  double seconds_ = 0.0;
};

/// Reads the header of a journal. Throws InputError if the file is not a journal or its header is damaged.
RunHeader read_run_header(const std::string& path);

}  // namespace armtune::internal
