#include "sim/csv/csv_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_set>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"
#include "core/common/nearest.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMaxColumns = 10'000;

void refuse_two_of_one_name(const std::vector<std::string>& header, const std::string& file) {
  std::unordered_set<std::string_view> seen;
  for (const std::string& name : header) {
    if (seen.insert(name).second) continue;
    throw InputError(at_line(file, 1, name),
                     fmt::format("two columns are called {}; remove or rename one", shown(name)))
        .with_value(name, "one column of each name");
  }
}

}  // namespace

std::vector<std::string> read_csv_header(CsvCells& cells, const std::string& text, const std::string& file) {
  std::vector<std::string> header;
  CsvCell cell;
  while (cells.next(cell)) {
    header.emplace_back(text, cell.begin, cell.end - cell.begin);
    if (header.size() > kMaxColumns) {
      throw InputError(at_line(file, 1), fmt::format("more than {} columns; is it a CSV file?", kMaxColumns))
          .with_value({}, fmt::format("at most {} columns", kMaxColumns));
    }
    if (cell.last_of_row) break;
  }
  if (cells.open_quote_line() > 0) refuse_open_quote(cells, file);
  if (header.empty() || !cell.has_line_end) throw InputError(InputPlace{file}, "has no header row");
  refuse_two_of_one_name(header, file);
  return header;
}

std::size_t byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? kMark.size() : 0;
}

std::optional<std::size_t> find_csv_column(const std::vector<std::string>& header, std::string_view name) {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.begin());
}

std::size_t csv_column(const std::vector<std::string>& header, const std::string& file,
                       std::string_view name) {
  if (const auto found = find_csv_column(header, name)) return *found;
  throw InputError(at_line(file, 1, std::string(name)),
                   fmt::format("no column '{}'{}", name, suggestion(name, header)))
      .with_value({}, fmt::format("a column '{}'", name));
}

double csv_number(std::string_view cell, const std::string& file, std::size_t line,
                  const std::string& column) {
  double value = NAN;
  if (cell.empty()) return value;
  const char* end = cell.data() + cell.size();
  const auto [read, error] = std::from_chars(cell.data(), end, value);
  if (read != end || error != std::errc())
    throw InputError(at_line(file, line, column),
                     fmt::format("{} in column {} is not a number", shown(cell), column))
        .with_value(std::string(cell), "a number");
  return value;
}

void refuse_csv_row(const std::string& file, std::size_t line, std::size_t cells, std::size_t header) {
  throw InputError(at_line(file, line),
                   fmt::format("the row has {} cells, but the header has {}; give every row as many "
                               "cells as the header",
                               cells, header))
      .with_value(std::to_string(cells), fmt::format("{} cells", header));
}

void refuse_open_quote(const CsvCells& cells, const std::string& file) {
  throw InputError(at_line(file, cells.open_quote_line()),
                   "the quote opened here is never closed; close it, or double it if it is part of the text");
}

}  // namespace armtune::internal
