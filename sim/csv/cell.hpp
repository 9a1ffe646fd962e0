#pragma once
// Formats a number or a text as one cell of a CSV file.

#include <string>

namespace armtune::internal {

/// Returns the number as text that reads back to the same bits. NaN and infinity become an empty cell, which
/// stands for a missing value.
std::string cell(double value);

/// Returns the text as a cell. A text with a comma, a double quote or a line end is put in double quotes. A
/// text that a spreadsheet would take for a formula gets an apostrophe in front.
std::string cell(const std::string& text);

}  // namespace armtune::internal
