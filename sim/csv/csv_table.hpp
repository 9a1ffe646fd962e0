#pragma once
// A CSV file read back, by the names of its columns.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armtune {

class CsvTable {
 public:
  /// Throws InputError naming the file if it cannot be read, and the line where a row has another number of
  /// cells than the header. A last row without its line end, of a run that was killed, is left out.
  static CsvTable read(const std::string& path);
  static CsvTable parse(std::string text, std::string name);

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
  std::string_view cell(std::size_t row, std::size_t column) const;

  std::string name_;
  std::string text_;  ///< quotes are taken out in place
  std::vector<std::string> header_;
  std::vector<std::size_t> begin_;  ///< of every cell in text_, row by row; its end is in end_
  std::vector<std::size_t> end_;
  std::size_t rows_ = 0;
};

}  // namespace armtune
