#pragma once
// Reads a whole CSV file into memory. Its columns are found by name.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armtune::internal {

class CsvCells;

/// The origin of a file. It decides how large the file may be, and whether a last row without a line end is
/// used.
enum class CsvOrigin {
  kArmtune,  ///< up to 256 MB; such a row is left out, because the run was killed while writing the row
  kUser,     ///< up to 48 MB; such a row is used
};

class CsvTable {
 public:
  /// Reads a file. A byte order mark is skipped. Throws InputError with file and line if:
  ///   - the file cannot be read, is too large or has no header row,
  ///   - two columns have the same name,
  ///   - a row has another number of cells than the header,
  ///   - a quote is never closed.
  static CsvTable read(const std::string& path, CsvOrigin origin = CsvOrigin::kArmtune);
  /// Does the same with the text of a file. name: name of the file in messages.
  static CsvTable parse(std::string text, std::string name, CsvOrigin origin = CsvOrigin::kArmtune);

  /// Returns the name of the file for messages.
  const std::string& name() const { return name_; }
  std::size_t rows() const { return rows_; }
  const std::vector<std::string>& header() const { return header_; }
  std::optional<std::size_t> find(std::string_view column) const;
  /// Returns the index of a column. Throws InputError naming file and column if there is none.
  std::size_t column(std::string_view name) const;

  /// Returns the cell without its quotes.
  std::string text(std::size_t row, std::size_t column) const;
  /// Returns a number; NaN if the cell is empty. Throws InputError naming file, line and column if the cell
  /// contains anything else.
  double number(std::size_t row, std::size_t column) const;
  /// Returns the numbers of a column, one per row.
  std::vector<double> numbers(std::size_t column) const;

 private:
  void read_rows(CsvCells& cells, CsvOrigin origin);
  std::string_view cell(std::size_t row, std::size_t column) const;

  std::string name_;
  std::string text_;  ///< quotes are removed in place
  std::vector<std::string> header_;
  std::vector<std::uint32_t> begin_;  ///< begin of every cell in text_, row by row; its end is in end_
  std::vector<std::uint32_t> end_;
  std::size_t rows_ = 0;
};

}  // namespace armtune::internal
