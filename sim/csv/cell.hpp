#pragma once
// A number or a text as a cell of a CSV file.

#include <string>

namespace armtune::internal {

/// Reads back to the same bits; empty for NaN and infinity, which stand for a value that there is not.
std::string cell(double value);

/// The text, in quotes where a reader would else take part of it for the end of the cell, and behind an
/// apostrophe where a spreadsheet would else take it for a formula.
std::string cell(const std::string& text);

}  // namespace armtune::internal
