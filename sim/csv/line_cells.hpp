#pragma once
// Splits one line of a text table into its cells. Tables of other programs separate cells by commas,
// semicolons, tabs or blanks.

#include <string_view>
#include <vector>

namespace armtune::internal {

/// Returns the separator of a table's cells: the comma, semicolon or tab that is most frequent in the first
/// line outside quotes. If there is none, returns a blank, which stands for any number of blanks and tabs.
char find_separator(std::string_view first_line);
/// Returns "commas", "semicolons", "tabs" or "blanks".
std::string_view separator_name(char separator);

/// Splits a line into cells (views of the line), without the blanks and quotes around each cell. A comma,
/// semicolon or tab between double quotes does not end a cell. If the separator is a blank, every blank or
/// tab ends a cell, also between quotes.
void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells);

}  // namespace armtune::internal
