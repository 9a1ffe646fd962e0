#pragma once
// Rows of a motion in a CSV file of a user's: times that rise, numbers that are finite.

#include <string>
#include <vector>

#include "sim/csv/csv_table.hpp"

namespace armtune::internal {

/// Line of the file that a row of the table stands in.
std::size_t line_of(std::size_t row);

/// Throws InputError naming file, line and column unless the cell is a finite number.
double finite_cell(const CsvTable& table, std::size_t row, std::size_t column, const std::string& path);

/// Returns column `time` [s], at least two times that rise from zero or later on. Throws InputError naming
/// file and line, for Unix time stamps too.
std::vector<double> rising_times(const CsvTable& table, const std::string& path);

}  // namespace armtune::internal
