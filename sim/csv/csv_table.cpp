#include "sim/csv/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/common/error.hpp"

namespace armtune {
namespace {

struct Cell {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool last_of_row = false;
};

/// Cell by cell; a quoted one is written back without its quotes, doubled ones once.
class CellReader {
 public:
  explicit CellReader(std::string& text) : text_(text) {}

  /// False at the end of the text, and in a row that has no line end.
  bool next(Cell& cell) {
    if (at_ >= text_.size()) return false;
    cell.begin = at_;
    std::size_t write = at_;
    bool quoted = false;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"') {
        const bool doubled = quoted && at_ + 1 < text_.size() && text_[at_ + 1] == '"';
        if (doubled)
          text_[write++] = text_[++at_];
        else
          quoted = !quoted;
      } else if (!quoted && (c == ',' || c == '\n')) {
        cell.end = write;
        cell.last_of_row = c == '\n';
        ++at_;
        if (cell.last_of_row && cell.end > cell.begin && text_[cell.end - 1] == '\r') --cell.end;
        return true;
      } else {
        text_[write++] = c;
      }
    }
    return false;
  }

 private:
  std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

CsvTable CsvTable::read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  return parse({std::istreambuf_iterator<char>(file), {}}, path);
}

CsvTable CsvTable::parse(std::string text, std::string name) {
  CsvTable table;
  table.name_ = std::move(name);
  table.text_ = std::move(text);
  CellReader reader(table.text_);
  Cell cell;
  while (reader.next(cell)) {
    table.header_.emplace_back(table.text_, cell.begin, cell.end - cell.begin);
    if (cell.last_of_row) break;
  }
  if (table.header_.empty() || !cell.last_of_row) throw InputError(table.name_ + ": has no header row");
  const std::size_t width = table.header_.size();
  std::size_t in_row = 0;
  while (reader.next(cell)) {
    table.begin_.push_back(cell.begin);
    table.end_.push_back(cell.end);
    ++in_row;
    if (!cell.last_of_row) continue;
    if (in_row != width) {
      throw InputError(fmt::format("{}:{}: {} cells where the header has {}", table.name_, table.rows_ + 2,
                                   in_row, width));
    }
    ++table.rows_;
    in_row = 0;
  }
  return table;
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  const auto found = std::find(header_.begin(), header_.end(), column);
  if (found == header_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header_.begin());
}

std::size_t CsvTable::column(std::string_view name) const {
  const auto found = find(name);
  if (!found) throw InputError(fmt::format("{}:1: no column '{}', which armtune writes", name_, name));
  return *found;
}

std::string_view CsvTable::cell(std::size_t row, std::size_t column) const {
  const std::size_t i = row * header_.size() + column;
  return std::string_view(text_).substr(begin_[i], end_[i] - begin_[i]);
}

std::string CsvTable::text(std::size_t row, std::size_t column) const {
  return std::string(cell(row, column));
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string_view text = cell(row, column);
  double value = NAN;
  if (text.empty()) return value;
  const char* end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, value);
  if (read != end || error != std::errc()) {
    throw InputError(
        fmt::format("{}:{}: '{}' in column {} is no number", name_, row + 2, text, header_[column]));
  }
  return value;
}

std::vector<double> CsvTable::numbers(std::size_t column) const {
  std::vector<double> values;
  values.reserve(rows_);
  for (std::size_t r = 0; r < rows_; ++r) values.push_back(number(r, column));
  return values;
}

}  // namespace armtune
