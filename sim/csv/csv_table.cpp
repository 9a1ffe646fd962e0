#include "sim/csv/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "sim/csv/csv_parts.hpp"

namespace armtune::internal {
namespace {

/// Every cell has two positions of four bytes, so that the largest table with its text stays below 500 MB. A
/// user's file of the largest size has about this many cells if each is a single digit.
constexpr std::size_t kMaxCells = 24'000'000;

std::size_t max_bytes(CsvOrigin origin) {
  return (origin == CsvOrigin::kUser ? std::size_t{48} : std::size_t{256}) << 20;
}

/// Returns the number of commas and line ends. It is an upper bound of the number of cells below the header.
std::size_t count_separators(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), ',') +
                                  std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

CsvTable CsvTable::read(const std::string& path, CsvOrigin origin) {
  const auto read = origin == CsvOrigin::kUser ? read_input_file : read_file;
  return parse(read(path, max_bytes(origin), "a CSV file"), path, origin);
}

CsvTable CsvTable::parse(std::string text, std::string name, CsvOrigin origin) {
  text.erase(0, byte_order_mark(text));
  CsvTable table;
  table.name_ = std::move(name);
  table.text_ = std::move(text);
  CsvCells cells(table.text_);
  table.header_ = read_csv_header(cells, table.text_, table.name_);
  table.read_rows(cells, origin);
  return table;
}

void CsvTable::read_rows(CsvCells& cells, CsvOrigin origin) {
  const std::size_t width = header_.size();
  const std::size_t most = count_separators(text_) + 1;
  if (most > kMaxCells) {
    throw InputError(InputPlace{name_}, fmt::format("more than {} cells; expected a smaller file", kMaxCells))
        .with_value({}, fmt::format("at most {} cells", kMaxCells));
  }
  begin_.reserve(most);
  end_.reserve(most);
  std::size_t in_row = 0;
  for (CsvCell cell; cells.next(cell);) {
    if (++in_row <= width) {
      begin_.push_back(static_cast<std::uint32_t>(cell.begin));
      end_.push_back(static_cast<std::uint32_t>(cell.end));
    }
    if (!cell.last_of_row) continue;
    if (origin == CsvOrigin::kArmtune && !cell.has_line_end) break;
    if (cells.open_quote_line() > 0) refuse_open_quote(cells, name_);
    if (in_row != width) refuse_csv_row(name_, rows_ + 2, in_row, width);
    ++rows_;
    in_row = 0;
  }
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  return find_csv_column(header_, column);
}

std::size_t CsvTable::column(std::string_view name) const {
  return csv_column(header_, name_, name);
}

std::string_view CsvTable::cell(std::size_t row, std::size_t column) const {
  const std::size_t i = row * header_.size() + column;
  return std::string_view(text_).substr(begin_[i], end_[i] - begin_[i]);
}

std::string CsvTable::text(std::size_t row, std::size_t column) const {
  return std::string(cell(row, column));
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  return csv_number(cell(row, column), name_, row + 2, header_[column]);
}

std::vector<double> CsvTable::numbers(std::size_t column) const {
  std::vector<double> values;
  values.reserve(rows_);
  for (std::size_t r = 0; r < rows_; ++r) values.push_back(number(r, column));
  return values;
}

}  // namespace armtune::internal
