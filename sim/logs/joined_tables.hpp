#pragma once
// Reads several text tables side by side. Some recorders write such tables, one file for each signal.

#include <memory>

#include "sim/logs/table_rows.hpp"
#include "sim/logs/text_table.hpp"

namespace armtune::internal {

/// Every file gives some columns of the same rows. A file of one column may have a multiple of the rows of
/// the others: it then holds the values of one row on several lines, and becomes as many columns. A column is
/// called by its header. Without a header it is called by its file, with an index if there are several, as in
/// velocity[0].
class JoinedTables final : public TableRows {
 public:
  /// Opens the files. Throws InputError as TextTable does. Also throws InputError, with the file, if its
  /// number of rows is not a multiple of the smallest number of rows, if it has more rows than that and more
  /// than one column, or if two columns have the same name.
  explicit JoinedTables(const std::vector<std::string>& paths);

  const std::vector<std::string>& names() const override { return names_; }
  const std::vector<std::string>& units() const override { return units_; }
  bool has_names() const override { return true; }
  bool decimal_comma() const override { return decimal_comma_; }
  std::string description() const override;
  bool next() override;
  const std::vector<std::string_view>& cells() const override { return views_; }
  long line() const override { return parts_.front().table->line(); }
  const std::string& file() const override { return parts_.front().table->file(); }
  long cut_rows() const override;

 private:
  struct Part {
    std::unique_ptr<TextTable> table;
    std::size_t lines_of_row = 1;
  };
  void add(const std::string& path, long rows, long least);

  std::vector<Part> parts_;
  std::vector<std::string> names_;
  std::vector<std::string> units_;
  std::vector<std::string> cells_;
  std::vector<std::string_view> views_;
  bool decimal_comma_ = false;
};

}  // namespace armtune::internal
