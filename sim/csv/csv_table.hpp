#pragma once
// A CSV file read back, by the names of its columns.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armtune::internal {

class CsvCells;

/// Whose file it is, and so how much of it is read and what a last row without its line end means.
enum class CsvOrigin {
  kArmtune,  ///< up to 256 MB; such a row was being written when the run was killed, and is left out
  kUser,     ///< up to 48 MB; such a row is a row
};

class CsvTable {
 public:
  /// Throws InputError with file and line for a file that cannot be read or is too large, one without a
  /// header row, two columns of one name, a row with another number of cells than the header, a quote that is
  /// never closed. A byte order mark is skipped.
  static CsvTable read(const std::string& path, CsvOrigin origin = CsvOrigin::kArmtune);
  static CsvTable parse(std::string text, std::string name, CsvOrigin origin = CsvOrigin::kArmtune);

  /// The file, as messages name it.
  const std::string& name() const { return name_; }
  std::size_t rows() const { return rows_; }
  const std::vector<std::string>& header() const { return header_; }
  std::optional<std::size_t> find(std::string_view column) const;
  /// Throws InputError naming file and column where there is none.
  std::size_t column(std::string_view name) const;

  /// The cell without its quotes.
  std::string text(std::size_t row, std::size_t column) const;
  /// NaN where the cell is empty. Throws InputError naming file, line and column where it holds no number.
  double number(std::size_t row, std::size_t column) const;
  /// One per row.
  std::vector<double> numbers(std::size_t column) const;

 private:
  void read_rows(CsvCells& cells, CsvOrigin origin);
  std::string_view cell(std::size_t row, std::size_t column) const;

  std::string name_;
  std::string text_;  ///< quotes are taken out in place
  std::vector<std::string> header_;
  std::vector<std::uint32_t> begin_;  ///< of every cell in text_, row by row; its end is in end_
  std::vector<std::uint32_t> end_;
  std::size_t rows_ = 0;
};

}  // namespace armtune::internal
