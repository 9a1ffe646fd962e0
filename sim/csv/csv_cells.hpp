#pragma once
// Splits a CSV text into its cells, one after another (RFC 4180, any line end). Only sim/csv uses this.

#include <cstddef>
#include <string>

namespace armtune::internal {

struct CsvCell {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool last_of_row = false;
  bool has_line_end = false;  ///< false in the last row of a text that ends without one
};

/// Reads the cells of a text. This changes the text: a quoted cell is written back without its quotes, and a
/// doubled quote as a single one.
class CsvCells {
 public:
  explicit CsvCells(std::string& text) : text_(text) {}

  /// Reads the next cell. Returns false at the end of the text.
  bool next(CsvCell& cell) {
    if (at_ >= text_.size() && !row_is_open_) return false;
    cell.begin = at_;
    std::size_t write = at_;
    bool quoted = false;
    std::size_t quote_line = line_;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n') ++line_;
      if (c == '"') {
        const bool doubled = quoted && at_ + 1 < text_.size() && text_[at_ + 1] == '"';
        if (doubled) {
          text_[write++] = text_[++at_];
        } else {
          quoted = !quoted;
          quote_line = line_;
        }
      } else if (!quoted && (c == ',' || c == '\n')) {
        ++at_;
        close(cell, write, c == '\n', c == '\n');
        return true;
      } else {
        text_[write++] = c;
      }
    }
    if (quoted) open_quote_line_ = quote_line;
    close(cell, write, true, false);
    return true;
  }

  /// Returns the line, counted from 1, of a quote that is never closed; 0 if there is none.
  std::size_t open_quote_line() const { return open_quote_line_; }

 private:
  void close(CsvCell& cell, std::size_t end, bool last_of_row, bool has_line_end) {
    if (last_of_row && end > cell.begin && text_[end - 1] == '\r') --end;
    cell.end = end;
    cell.last_of_row = last_of_row;
    cell.has_line_end = has_line_end;
    row_is_open_ = !last_of_row;
  }

  std::string& text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t open_quote_line_ = 0;
  bool row_is_open_ = false;
};

}  // namespace armtune::internal
