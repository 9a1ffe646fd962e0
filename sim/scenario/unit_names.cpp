#include "sim/scenario/unit_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"
#include "sim/csv/line_cells.hpp"

namespace armtune::internal {
namespace {

/// Returns true if a column has brackets after its name: "x [m]", "time (s)".
bool has_brackets(std::string_view name) {
  const std::size_t open = name.find_last_of("[(");
  return open != std::string_view::npos && open > 0 && (name.ends_with(']') || name.ends_with(')'));
}

/// Returns the name of a column without its unit. Throws InputError if the unit contradicts `units`.
std::string without_unit(std::string_view name, const std::string& path, const yaml::FileUnits& units) {
  if (!has_brackets(name)) return std::string(name);
  const std::size_t open = name.find_last_of("[(");
  const std::string unit(name.substr(open + 1, name.size() - open - 2));
  if (!yaml::check_unit(unit, units, at_line(path, 1, std::string(name)))) return std::string(name);
  const std::size_t last = name.find_last_not_of(' ', open - 1);
  return std::string(name.substr(0, last == std::string_view::npos ? 0 : last + 1));
}

std::string in_lower_case(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

/// Gives the column of the time its name, unless there is one of this name.
void name_time(std::vector<std::string>& columns) {
  if (std::find(columns.begin(), columns.end(), "time") != columns.end()) return;
  for (const char* known : {"time", "t", "time_from_start"}) {
    const auto time = std::find_if(columns.begin(), columns.end(),
                                   [known](const std::string& name) { return in_lower_case(name) == known; });
    if (time == columns.end()) continue;
    *time = "time";
    return;
  }
}

}  // namespace

std::string plain_names(const std::string& line, const std::string& path, const yaml::FileUnits& units) {
  std::vector<std::string_view> cells;
  split_cells(line, ',', cells);
  std::vector<std::string> plain;
  plain.reserve(cells.size());
  for (const std::string_view cell : cells) plain.push_back(without_unit(cell, path, units));
  // A column with an unknown unit would be ignored silently while the others are read.
  bool any_unit = false;
  for (std::size_t i = 0; i < cells.size(); ++i) any_unit = any_unit || plain[i] != cells[i];
  for (const std::string& name : plain) {
    if (any_unit && has_brackets(name))
      throw InputError(
          at_line(path, 1, name),
          fmt::format("column {} has an unknown unit; take the units out of the column names", shown(name)))
          .with_value(name, "column names without units");
  }
  name_time(plain);
  return fmt::format("{}", fmt::join(plain, ","));
}

}  // namespace armtune::internal
