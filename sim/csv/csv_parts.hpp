#pragma once
// Private to sim/csv: what every reader of CSV files does with a header and with a cell.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/csv/csv_cells.hpp"

namespace armtune::internal {

/// Reads the first row of `text`, whose cells are `cells`. Throws InputError naming `file` where there is
/// none with a line end, for over 10,000 columns, for two of one name and for a quote that is never closed.
std::vector<std::string> read_csv_header(CsvCells& cells, const std::string& text, const std::string& file);

/// Size of the byte order mark that the text begins with; 0 without one.
std::size_t byte_order_mark(std::string_view text);

/// Returns the index of a column, or nothing.
std::optional<std::size_t> find_csv_column(const std::vector<std::string>& header, std::string_view name);

/// Returns the same; throws InputError naming file and column, and a similar one, where there is none.
std::size_t csv_column(const std::vector<std::string>& header, const std::string& file,
                       std::string_view name);

/// Returns a cell's number; NaN where it is empty. Throws InputError naming file, line and column where it
/// holds none.
double csv_number(std::string_view cell, const std::string& file, std::size_t line,
                  const std::string& column);

/// Throws InputError: a row has another number of cells than the header.
[[noreturn]] void refuse_csv_row(const std::string& file, std::size_t line, std::size_t cells,
                                 std::size_t header);

/// Throws InputError naming the line of the quote that the text ends within.
[[noreturn]] void refuse_open_quote(const CsvCells& cells, const std::string& file);

}  // namespace armtune::internal
