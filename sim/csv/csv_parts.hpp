#pragma once
// Functions that all readers of CSV files share. They read the header row, find columns by name, convert
// cells to numbers and throw the errors for malformed rows.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/csv/csv_cells.hpp"

namespace armtune::internal {

/// Reads the first row of `text`, whose cells are `cells`. Throws InputError naming `file` if there is no
/// first row with a line end, if it has over 10,000 columns, if two columns have the same name, or if a quote
/// is never closed.
std::vector<std::string> read_csv_header(CsvCells& cells, const std::string& text, const std::string& file);

/// Returns the size of the byte order mark at the beginning of the text [byte]; 0 if there is none.
std::size_t byte_order_mark(std::string_view text);

/// Returns the index of a column, or nothing if there is none of that name.
std::optional<std::size_t> find_csv_column(const std::vector<std::string>& header, std::string_view name);

/// Returns the index of a column. Throws InputError if there is none of that name. The message names the file
/// and the column, and suggests a column with a similar name if there is one.
std::size_t csv_column(const std::vector<std::string>& header, const std::string& file,
                       std::string_view name);

/// Returns a cell's number; NaN if the cell is empty. Throws InputError naming file, line and column if the
/// cell contains anything else.
double csv_number(std::string_view cell, const std::string& file, std::size_t line,
                  const std::string& column);

/// Throws the InputError for a row that has another number of cells than the header.
[[noreturn]] void refuse_csv_row(const std::string& file, std::size_t line, std::size_t cells,
                                 std::size_t header);

/// Throws InputError naming the line of the quote that is still open at the end of the text.
[[noreturn]] void refuse_open_quote(const CsvCells& cells, const std::string& file);

}  // namespace armtune::internal
