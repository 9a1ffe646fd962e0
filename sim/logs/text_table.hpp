#pragma once
// A text table in one of the shapes that recorders write. Its separator, its header and its units are
// recognised:
//
//   - cells are separated by commas, semicolons, tabs or blanks; numbers may have decimal commas if the
//     separator is another character;
//   - lines that begin with #, % or // are comments. The last of them is the header if it has as many cells
//     as the first row and the first row holds numbers;
//   - otherwise, the first line that is not a comment is the header, unless it holds numbers. Columns of the
//     same name are numbered, as in q[0], q[1]. If the line after the header holds no number, it gives
//     the units;
//   - blank lines are skipped.

#include "sim/csv/text_lines.hpp"
#include "sim/logs/table_rows.hpp"

namespace armtune::internal {

class TextTable final : public TableRows {
 public:
  /// Opens a file and reads its header. Throws InputError with file and line if:
  ///   - the file cannot be read, is empty, is not text, or has a line of more than 1 MB,
  ///   - it has more than 10,000 columns.
  explicit TextTable(const std::string& path);

  const std::vector<std::string>& names() const override { return names_; }
  const std::vector<std::string>& units() const override { return units_; }
  bool has_names() const override { return has_names_; }
  bool decimal_comma() const override { return decimal_comma_; }
  std::string description() const override;

  /// Throws InputError with file and line if a row has another number of cells than the header. An empty cell
  /// after a separator at the end of a row is ignored, and a last row that ends too early is left out.
  bool next() override;
  const std::vector<std::string_view>& cells() const override { return cells_; }
  long line() const override { return line_; }
  const std::string& file() const override { return path_; }
  long cut_rows() const override { return cut_rows_; }

 private:
  bool next_line();
  void read_header();
  void find_shape(std::string_view line);
  void take_names(const std::vector<std::string>& comment);
  void read_units();
  void name_columns();
  bool holds_numbers() const;
  bool fits();

  std::string path_;
  TextLines lines_;
  char separator_ = ',';
  bool decimal_comma_ = false;
  bool has_names_ = false;
  bool waiting_ = false;  ///< true if cells_ already holds the row that next() returns
  std::vector<std::string> names_;
  std::vector<std::string> units_;
  std::vector<std::string_view> cells_;
  long line_ = 0;
  long cut_rows_ = 0;
};

}  // namespace armtune::internal
