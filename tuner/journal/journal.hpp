#pragma once
// journal.txt: every finished evaluation of a run, whole and checked, so that a run that was killed resumes
// where it was. A line each: a checksum (16 hexadecimal digits) over the rest of the line.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "tuner/journal/record.hpp"
#include "tuner/journal/run_header.hpp"
#include "tuner/run/append_file.hpp"

namespace armtune::internal {

/// Whose minutes: those of the whole run, what a search may use of them that leaves some for its last steps,
/// or what a global search may use that leaves some for the local one.
enum class Minutes { kRun, kSearch, kGlobal };

class Journal {
 public:
  /// Begins one, its header on disk. Throws InputError if the file is there already or cannot be made.
  static std::unique_ptr<Journal> begin(const std::string& path, const RunHeader& header);

  /// Opens one to go on with. A torn last line, of a run that was killed while it wrote, is cut off;
  /// `warning` says so. patience: how long to wait for another process that writes it [s]. Throws InputError
  /// if the file cannot be read, a line is damaged (naming the record), another process is writing it, or
  /// `now` is another run than the one it was begun for (naming what differs).
  static std::unique_ptr<Journal> resume(const std::string& path, const RunHeader& now, std::string& warning,
                                         double patience = 0.0);

  /// The record of this number, if it is finished. Throws InputError if the file was changed meanwhile.
  std::optional<JournalRecord> find(std::uint64_t number) const;
  std::size_t records() const { return places_.size(); }
  /// Appends a record and hands it to the disk. Throws FailedError if the disk refuses it.
  void append(const JournalRecord& record);

  /// The number of the evaluation before which those minutes were over, if that happened.
  std::optional<std::uint64_t> time_was_up(Minutes minutes = Minutes::kRun) const;
  void time_is_up(std::uint64_t number, Minutes minutes = Minutes::kRun);

  /// Exit code of the program, once everything the run was to make is written.
  std::optional<int> exit_code() const { return exit_code_; }
  void complete(int exit_code);

  /// Wall time of the run until its last record [s].
  double seconds() const { return seconds_; }

 private:
  Journal(const std::string& path, AppendFile::Open open, double patience);
  /// Reads the lines after the header; gives what to warn of.
  std::string read(const RunHeader& now);
  void take(std::string_view payload, long place);
  void write(const std::string& payload);

  std::string path_;
  AppendFile file_;
  long size_ = 0;                         ///< of the file [bytes]
  std::map<std::uint64_t, long> places_;  ///< of the finished: where their lines begin
  std::map<Minutes, std::uint64_t> time_was_up_;
  std::optional<int> exit_code_;
  double seconds_ = 0.0;
};

/// The header of a journal. Throws InputError if it is none or its header is damaged.
RunHeader read_run_header(const std::string& path);

}  // namespace armtune::internal
