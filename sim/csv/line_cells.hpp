#pragma once
// Splits one line of a text table into its cells. Tables of other programs separate cells by commas,
// semicolons, tabs or blanks.

#include <string_view>
#include <vector>

namespace armtune::internal {

/// Returns the separator of a table's cells: a comma, a semicolon, a tab, or a blank for one or more blanks.
char find_separator(std::string_view first_line);
/// Returns "commas", "semicolons", "tabs" or "blanks".
std::string_view separator_name(char separator);

/// Splits a line into cells (views of it) without the blanks and quotes around them. A separator between
/// double quotes belongs to its cell.
void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells);

}  // namespace armtune::internal
