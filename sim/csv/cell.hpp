#pragma once
// A number as a cell of a CSV file.

#include <string>

namespace armtune {

/// Reads back to the same bits; empty for NaN, which stands for a value that there is not.
std::string cell(double value);

}  // namespace armtune
