#pragma once
// The rows of a text log, before its numbers are read: the rows of one file, or of several files side by
// side.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace armtune::internal {

class TableRows {
 public:
  virtual ~TableRows() = default;

  /// Names of the columns, each different; "1", "2" and so on if the file has no header.
  virtual const std::vector<std::string>& names() const = 0;
  /// Units of the columns as the file states them; "" where it states none. As many as names().
  virtual const std::vector<std::string>& units() const = 0;
  virtual bool has_names() const = 0;
  /// True if numbers have decimal commas.
  virtual bool decimal_comma() const = 0;
  /// The name of the separator, such as "commas", and the number of columns, for people.
  virtual std::string description() const = 0;

  /// Moves to the next row. Returns false at the end.
  virtual bool next() = 0;
  /// The cells of the row, as many as names(); valid until next() is called.
  virtual const std::vector<std::string_view>& cells() const = 0;
  /// The line of the row in file(), counted from 1.
  virtual long line() const = 0;
  virtual const std::string& file() const = 0;
  /// Rows at the end that were cut off in the middle and left out; valid after the last row.
  virtual long cut_rows() const = 0;
};

/// Opens the table of one file, or the tables of several files side by side (joined_tables.hpp). Throws
/// InputError as TextTable and JoinedTables do.
std::unique_ptr<TableRows> open_table(const std::vector<std::string>& paths);

}  // namespace armtune::internal
