#pragma once
// Reads columns of numbers from a long CSV file that armtune wrote, such as the recording of one simulated
// hour. To save memory, it reads the file block by block and keeps only the requested columns.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/csv/csv_table.hpp"

namespace armtune::internal {

class NumberTable {
 public:
  /// Reads a file and keeps the columns for whose names `wanted` returns true. A last row without a line end
  /// is left out, because the run was killed while writing it. Throws InputError with file and line as
  /// CsvTable does, and also if a wanted cell is neither empty nor a number. Throws InputError with the file
  /// if there are more than 40 million wanted cells.
  static NumberTable read(const std::string& path, const std::function<bool(std::string_view)>& wanted);
  /// Keeps all columns of a table that was read already. Throws InputError if a cell is neither empty nor a
  /// number.
  NumberTable(const CsvTable& table);  // NOLINT(google-explicit-constructor): a table of numbers is one

  std::size_t rows() const { return rows_; }
  /// Returns the names of the columns that were kept, in the file's order.
  const std::vector<std::string>& header() const { return header_; }
  /// Returns the index of a column that was kept.
  std::optional<std::size_t> find(std::string_view column) const;
  /// Returns the index of a column that was kept. Throws InputError naming file and column if there is none
  /// of that name.
  std::size_t column(std::string_view name) const;
  /// Returns the numbers of a column, one per row; NaN where the cell is empty.
  const std::vector<double>& numbers(std::size_t column) const { return values_[column]; }
  double number(std::size_t row, std::size_t column) const { return values_[column][row]; }
  /// Returns the name of the file.
  const std::string& name() const { return name_; }

 private:
  explicit NumberTable(std::string name) : name_(std::move(name)) {}
  void take(std::string rows, const std::function<bool(std::string_view)>& wanted);

  std::string name_;
  std::vector<std::string> header_;
  std::vector<std::vector<double>> values_;  ///< one per column that was kept
  std::vector<long> place_;                  ///< index in values_ of each of the file's columns; -1: not kept
  std::size_t rows_ = 0;
};

}  // namespace armtune::internal
