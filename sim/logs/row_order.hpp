#pragma once
// Puts the rows of a log into the order of their time stamps, within stated bounds.

#include <deque>
#include <string>
#include <vector>

namespace armtune::internal {

struct LogRow {
  double time = 0.0;          ///< since the first row of the log that was read [s]
  long line = 0;              ///< in the file, counted from 1; 0: not known
  std::vector<double> value;  ///< one per channel; NaN: missing
};

/// How far a log is repaired. A log that needs more is refused.
struct RepairBounds {
  static constexpr std::size_t kWindow = 64;     ///< largest number of rows by which a row is moved back
  static constexpr double kMovedShare = 0.05;    ///< largest share of rows that are moved
  static constexpr double kRepeatedShare = 0.1;  ///< largest share of rows whose time stamp is a repetition
  static constexpr double kNoTimeShare = 0.01;   ///< largest share of rows without a time stamp
  static constexpr long kAllowed = 2;            ///< number of rows of each kind that is always accepted
};

/// What was repaired in a log.
struct LogRepairs {
  long repeated = 0;  ///< rows that were dropped, because a row before has the same time stamp
  long moved = 0;     ///< rows that were sorted
  long no_time = 0;   ///< rows that were dropped, because they have no time stamp
  long cut = 0;       ///< rows that were dropped at the end, because they were cut off
};

/// Sorts rows that arrive nearly in order. Only the rows of the window are kept in memory.
class RowOrder {
 public:
  /// file and key: for messages; the key is the name of the time column or of the topic.
  RowOrder(std::string file, std::string key) : file_(std::move(file)), key_(std::move(key)) {}

  /// Takes a row. The content of `row` is not defined afterwards, but its memory can be used for the next
  /// row. Throws InputError with file, line and key if the row belongs before rows that were already given
  /// out. It then stands more than kWindow rows too late, or the recording was restarted.
  void push(LogRow& row);
  /// Sets `row` to the next row in the order of time. Returns false if more rows must be pushed first. With
  /// `end`, returns false only if no row is left.
  bool pop(LogRow& row, bool end);
  /// Throws InputError with file and key if more rows were dropped or sorted than RepairBounds allow. Must be
  /// called after the last row.
  void check_bounds() const;

  const LogRepairs& repairs() const { return repairs_; }
  /// These count rows that never reach push().
  void count_row_without_time() { ++repairs_.no_time; }
  void count_cut_rows(long rows) { repairs_.cut = rows; }

 private:
  std::string file_;
  std::string key_;
  std::deque<LogRow> window_;
  std::vector<std::vector<double>> free_;
  LogRepairs repairs_;
  long rows_ = 0;
  double last_ = 0.0;  ///< time of the last row that was given out [s]
  bool any_ = false;
};

}  // namespace armtune::internal
