#include "sim/csv/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "sim/csv/csv_parts.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kFirstBlock = std::size_t{1} << 16;
constexpr std::size_t kBlock = std::size_t{1} << 20;
constexpr std::size_t kMaxRowBytes = std::size_t{16} << 20;
constexpr std::size_t kMaxCells = 40'000'000;  // 320 MB

/// Returns the position after the last line end outside of quotes; 0 if there is none.
std::size_t end_of_whole_rows(std::string_view text) {
  std::size_t end = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (text[i] == '\n' && !quoted) end = i + 1;
  }
  return end;
}

}  // namespace

NumberTable NumberTable::read(const std::string& path, const std::function<bool(std::string_view)>& wanted) {
  NumberTable table(path);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw InputError(InputPlace{path},
                     fmt::format("cannot be opened: {}", std::generic_category().message(errno)));
  std::string text;
  bool first = true;
  while (file) {
    const std::size_t before = text.size();
    const std::size_t block = first ? kFirstBlock : kBlock;
    text.resize(before + block);
    file.read(&text[before], static_cast<std::streamsize>(block));
    text.resize(before + static_cast<std::size_t>(file.gcount()));
    if (first) text.erase(0, byte_order_mark(text));
    first = false;
    const std::size_t end = end_of_whole_rows(text);
    if (end > 0) table.take(text.substr(0, end), wanted);
    text.erase(0, end);
    if (text.size() > kMaxRowBytes) {
      throw InputError(at_line(path, table.place_.empty() ? 1 : table.rows_ + 2),
                       fmt::format("a row of more than {} MB; is it a CSV file?", kMaxRowBytes >> 20))
          .with_value({}, fmt::format("at most {} MB", kMaxRowBytes >> 20));
    }
  }
  if (file.bad()) throw InputError(InputPlace{path}, "cannot be read");
  if (table.place_.empty()) throw InputError(InputPlace{path}, "has no header row");
  return table;
}

NumberTable::NumberTable(const CsvTable& table)
    : name_(table.name()), header_(table.header()), rows_(table.rows()) {
  for (std::size_t c = 0; c < header_.size(); ++c) values_.push_back(table.numbers(c));
}

void NumberTable::take(std::string rows, const std::function<bool(std::string_view)>& wanted) {
  CsvCells cells(rows);
  if (place_.empty()) {
    for (std::string& name : read_csv_header(cells, rows, name_)) {
      const bool keep = wanted(name);
      place_.push_back(keep ? static_cast<long>(header_.size()) : -1);
      if (keep) header_.push_back(std::move(name));
    }
    values_.resize(header_.size());
  }
  std::size_t in_row = 0;
  for (CsvCell cell; cells.next(cell);) {
    if (in_row < place_.size() && place_[in_row] >= 0) {
      const auto column = static_cast<std::size_t>(place_[in_row]);
      const std::string_view text = std::string_view(rows).substr(cell.begin, cell.end - cell.begin);
      values_[column].push_back(csv_number(text, name_, rows_ + 2, header_[column]));
    }
    ++in_row;
    if (!cell.last_of_row) continue;
    if (in_row != place_.size()) refuse_csv_row(name_, rows_ + 2, in_row, place_.size());
    in_row = 0;
    if (++rows_ * std::max<std::size_t>(1, header_.size()) > kMaxCells)
      throw InputError(InputPlace{name_},
                       fmt::format("more than {} numbers; expected a smaller file", kMaxCells))
          .with_value({}, fmt::format("at most {} numbers", kMaxCells));
  }
}

std::optional<std::size_t> NumberTable::find(std::string_view column) const {
  return find_csv_column(header_, column);
}

std::size_t NumberTable::column(std::string_view name) const {
  return csv_column(header_, name_, name);
}

}  // namespace armtune::internal
