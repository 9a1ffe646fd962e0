#pragma once
// Finds the columns of a text log that hold its time, and the unit of their time stamps.

#include <optional>
#include <string>

#include "sim/logs/log_number.hpp"
#include "sim/logs/table_rows.hpp"

namespace armtune::internal {

enum class TimeUnit { kSeconds, kMilliseconds, kMicroseconds, kNanoseconds };

/// Returns the length of the unit [s].
double seconds(TimeUnit unit);
/// Returns "s", "ms", "us" or "ns".
const char* symbol(TimeUnit unit);
/// Returns the unit of that symbol, or nothing.
std::optional<TimeUnit> time_unit(std::string_view symbol);

/// What the user says about the time of a text log. Empty members are found from the file.
struct TimeOptions {
  std::optional<TimeUnit> unit;  ///< of the time stamps
  std::optional<double> rate;  ///< [Hz]; the rows are evenly spaced, and time stamps in the file are ignored
  std::string column;          ///< name of the column with the time stamps
};

struct TimeColumns {
  std::optional<std::size_t> column;       ///< of the time stamps; none: the rows are evenly spaced
  std::optional<std::size_t> nanoseconds;  ///< of a pair of columns, such as secs and nsecs; none: no pair
  double scale = 1.0;                      ///< of the time stamps, or the time between rows [s]
  std::string reason;                      ///< how they were found, for people

  bool is_time(std::size_t c) const { return column == c || nanoseconds == c; }
  /// Returns the time stamp of a row, in the unit of the file, or nothing if the row has none.
  std::optional<Stamp> stamp(const std::vector<std::string_view>& cells, bool decimal_comma) const;
};

/// Finds the time columns. `rows` is read to its end, or for 1,000 rows. A column is found by its name, such
/// as time, t, timestamp, stamp or header.stamp.secs. If no name fits, a column whose last word is time, or
/// one of the first three columns, is taken if it increases evenly. The unit is the one that the file states.
/// Otherwise it is found from the size of Unix time stamps, or else from the time between rows: the largest
/// unit in which the median step is below 0.5 s is taken. Throws InputError with file and key `--rate` if
/// there is no time column, and with key `--time` if the column that the user names does not exist.
TimeColumns find_time_columns(TableRows& rows, const TimeOptions& options);

}  // namespace armtune::internal
