#pragma once
// Formats a number or a text as one cell of a CSV file.

#include <string>

namespace armtune::internal {

/// Returns the number as text that reads back to the same bits. NaN and infinity become an empty cell, which
/// stands for a missing value.
std::string cell(double value);

/// Returns the text as a cell. It is in quotes if a reader would otherwise end the cell within it. It begins
/// with an apostrophe if a spreadsheet would otherwise take it for a formula.
std::string cell(const std::string& text);

}  // namespace armtune::internal
