#pragma once
// Reads a text log row by row, in the order of time, in bounded memory:
//
//     CsvLog log({"run.csv"}, {});
//     for (LogRow row; log.next(row);) use(row.time, row.value);

#include <memory>
#include <string>
#include <vector>

#include "sim/logs/row_order.hpp"
#include "sim/logs/table_rows.hpp"
#include "sim/logs/time_column.hpp"

namespace armtune::internal {

/// A channel is every column that holds numbers and is not the time. Columns of text are skipped. Rows are
/// repaired within RepairBounds.
class CsvLog {
 public:
  /// Opens the files, which are read side by side if there are several (joined_tables.hpp). Throws InputError
  /// as open_table and find_time_columns do, and with the file if it has no rows, or no column of numbers
  /// beside the time.
  CsvLog(const std::vector<std::string>& paths, const TimeOptions& options);

  /// Names and units ("" if not stated) of the channels.
  const std::vector<std::string>& channels() const { return channels_; }
  const std::vector<std::string>& units() const { return units_; }
  /// Names of the columns that were skipped, because they hold text.
  const std::vector<std::string>& skipped() const { return skipped_; }
  bool has_names() const { return rows_->has_names(); }
  /// How the file was understood: a line about its columns and one about its time, for people.
  std::string description() const;
  /// The first time stamp of the file [s]; 0 if the rows are evenly spaced. Valid after the first row.
  double start() const { return start_; }

  /// Sets `row` to the next row. Its time is relative to the first row of the file and may be negative in a
  /// repaired log. Returns false at the end. Throws InputError with file, line and column if a row cannot be
  /// read or a cell is not a number. Also throws InputError as RowOrder does.
  bool next(LogRow& row);
  /// What was repaired; complete after the last row.
  const LogRepairs& repairs() const { return order_.repairs(); }

 private:
  void find_channels(const std::vector<std::string>& paths);
  bool read_row();
  bool read_time(LogRow& row);
  double read_value(std::size_t column) const;

  std::unique_ptr<TableRows> rows_;
  TimeColumns time_;
  std::vector<std::size_t> places_;  ///< column of each channel
  std::vector<std::string> channels_;
  std::vector<std::string> units_;
  std::vector<std::string> skipped_;
  RowOrder order_;
  LogRow row_;
  Stamp first_;
  double start_ = 0.0;
  long read_ = 0;
  bool at_end_ = false;
};

}  // namespace armtune::internal
