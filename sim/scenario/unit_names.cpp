#include "sim/scenario/unit_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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
          fmt::format("column {} has an unknown unit; take the units out of the column names", shown(name)));
  }
  const auto is_time = [](const std::string& name) { return name == "time" || name == "Time"; };
  if (std::none_of(plain.begin(), plain.end(), is_time)) {
    const auto t = std::find_if(plain.begin(), plain.end(), [](const std::string& name) {
      return name == "t" || name == "T" || name == "time_from_start";
    });
    if (t != plain.end()) *t = "time";
  }
  return fmt::format("{}", fmt::join(plain, ","));
}

}  // namespace armtune::internal
