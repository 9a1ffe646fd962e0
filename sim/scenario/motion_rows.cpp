#include "sim/scenario/motion_rows.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"

namespace armtune::internal {
namespace {

constexpr double kLatest = 1e8;  // s: three years; Unix time stamps are over ten times larger

}  // namespace

std::size_t line_of(std::size_t row) {
  return row + 2;
}

double finite_cell(const CsvTable& table, std::size_t row, std::size_t column, const std::string& path) {
  const double value = table.number(row, column);
  if (std::isfinite(value)) return value;
  const std::string text = table.text(row, column);
  throw InputError(at_line(path, line_of(row), table.header()[column]),
                   fmt::format("{} in column {} is not a finite number; every row of a motion needs one",
                               text.empty() ? "an empty cell" : shown(text), table.header()[column]))
      .with_value(text, "a finite number");
}

std::vector<double> rising_times(const CsvTable& table, const std::string& path) {
  const std::size_t column = table.column("time");
  std::vector<double> time;
  time.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    time.push_back(finite_cell(table, row, column, path));
    if (row == 0 && time[0] > kLatest) {
      throw InputError(
          at_line(path, line_of(row), "time"),
          fmt::format(
              "time begins at {:.15g} s, which looks like a Unix time stamp; subtract the first time from "
              "all rows, so that the motion begins at 0 s",
              time[0]))
          .with_value(table.text(row, column), fmt::format("at most {:g}", kLatest));
    }
    if (row == 0 && time[0] < 0.0) {
      throw InputError(
          at_line(path, line_of(row), "time"),
          fmt::format("time is {} s; it must not be negative: shift the motion to begin at 0 s", time[0]))
          .with_value(table.text(row, column), "at least 0");
    }
    if (row == 0 || time[row] > time[row - 1]) continue;
    throw InputError(at_line(path, line_of(row), "time"),
                     fmt::format("time {} s is not later than {} s in the row before; times must rise",
                                 time[row], time[row - 1]))
        .with_value(table.text(row, column), fmt::format("above {}", time[row - 1]));
  }
  if (time.size() < 2) {
    throw InputError(InputPlace{path}, fmt::format("{} rows; a motion needs at least two", time.size()))
        .with_value(std::to_string(time.size()), "at least 2 rows");
  }
  return time;
}

}  // namespace armtune::internal
