#pragma once
// Reads the rows of a motion from a user's CSV file, and checks that the times rise and that all numbers are
// finite.

#include <string>
#include <vector>

#include "sim/csv/csv_table.hpp"

namespace armtune::internal {

/// Returns the line of the file, counted from 1, that contains a row of the table, counted from 0.
std::size_t line_of(std::size_t row);

/// Returns the number in a cell. Throws InputError naming file, line and column unless it is finite.
double finite_cell(const CsvTable& table, std::size_t row, std::size_t column, const std::string& path);

/// Returns the column `time` [s]. Throws InputError naming the file and, where known, the line if there are
/// fewer than two times, if the times do not rise, if the first one is negative, or if it looks like a Unix
/// time stamp.
std::vector<double> rising_times(const CsvTable& table, const std::string& path);

}  // namespace armtune::internal
