#pragma once
// Rows of a motion in a user's CSV file: their times must rise and their numbers must be finite.

#include <string>
#include <vector>

#include "sim/csv/csv_table.hpp"

namespace armtune::internal {

/// Returns the line of the file that holds a row of the table.
std::size_t line_of(std::size_t row);

/// Returns the number in a cell. Throws InputError naming file, line and column unless it is finite.
double finite_cell(const CsvTable& table, std::size_t row, std::size_t column, const std::string& path);

/// Returns column `time` [s]: at least two times that rise from zero or later on. Throws InputError naming
/// file and line otherwise, and also for Unix time stamps.
std::vector<double> rising_times(const CsvTable& table, const std::string& path);

}  // namespace armtune::internal
