#include "sim/scenario/user_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"
#include "sim/csv/csv_parts.hpp"
#include "sim/csv/line_cells.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/motion_rows.hpp"
#include "sim/scenario/unit_names.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMostBytes = 48U << 20;
constexpr std::ptrdiff_t kMostCells = 10'000;  // in a line

/// Returns the text with commas between its cells, whichever separator the file has. Throws InputError for a
/// cell that contains a comma.
std::string with_commas(std::string_view text, const std::string& path, ColumnNames names) {
  std::string result;
  result.reserve(text.size() + 1);
  std::vector<std::string_view> cells;
  char separator = ',';
  long number = 0;
  text.remove_prefix(byte_order_mark(text));
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (++number == 1) separator = find_separator(line);
    if (line.find_first_not_of(" \t") == std::string_view::npos) {
      if (number == 1)
        throw InputError(at_line(path, 1), "the first line is empty; remove it")
            .with_value({}, "column names");
      if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) break;  // empty lines at the end
    }
    if (std::count(line.begin(), line.end(), separator) > kMostCells)
      throw InputError(at_line(path, number),
                       fmt::format("more than {} cells in one line; is it a CSV file?", kMostCells))
          .with_value({}, fmt::format("at most {} cells", kMostCells));
    split_cells(line, separator, cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].find(',') != std::string_view::npos) {
        throw InputError(
            at_line(path, number),
            fmt::format(
                "the cell {} contains a comma, although the cells are separated by {}; write numbers with "
                "a decimal point",
                shown(std::string(cells[i])), separator_name(separator)))
            .with_value(std::string(cells[i]), "a number with a decimal point");
      }
      result += i > 0 ? "," : "";
      result += cells[i];
    }
    if (number == 1 && names == ColumnNames::kInLowerCase) {
      std::transform(result.begin(), result.end(), result.begin(),
                     [](unsigned char c) { return static_cast<char>(c < 128 ? std::tolower(c) : c); });
    }
    result += '\n';
  }
  return result;
}

bool is_number(std::string_view text) {
  double value = 0.0;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

/// Returns true if the first line of a table with commas has only numbers.
bool has_no_names(const std::string& text) {
  std::vector<std::string_view> cells;
  split_cells(std::string_view(text).substr(0, text.find('\n')), ',', cells);
  return std::all_of(cells.begin(), cells.end(), is_number);
}

}  // namespace

UserTable read_user_table(yaml::MapReader& map, const char* units) {
  UserTable table;
  const yaml::Node& file = map.required("file");
  table.path = file_beside(file.as_string(), file.file());
  if (const yaml::Node* given = map.optional("units")) {
    table.units = yaml::read_file_units(*given, units);
    table.has_units = true;
  }
  if (const yaml::Node* columns = map.optional("columns")) table.columns = columns->as_strings();
  return table;
}

ParsedTable parse_user_table(const UserTable& file, ColumnNames names, const std::string& key,
                             const std::string& columns) {
  const std::string& path = file.path;
  std::string text = with_commas(read_input_file(path, kMostBytes, "a CSV file"), path, names);
  std::string name = path;
  const std::size_t end = std::min(text.find('\n'), text.size());  // end of the first line
  if (has_no_names(text)) {
    if (file.columns.empty()) {
      throw InputError(
          at_line(path, 1),
          fmt::format("the first line has numbers instead of column names; add a line of names, or name the "
                      "columns in the scenario: {}: {{file: {}, columns: [{}]}}",
                      key, yaml::quoted(std::filesystem::path(path).filename().string()), columns))
          .with_value({}, "column names");
    }
    text.insert(0, fmt::format("{}\n", fmt::join(file.columns, ",")));
    name += " (with a line of names added)";
  } else if (!file.columns.empty()) {
    text.replace(0, end, fmt::format("{}", fmt::join(file.columns, ",")));
  } else {
    text.replace(0, end, plain_names(text.substr(0, end), path, file.units));
  }
  return {CsvTable::parse(std::move(text), name, CsvOrigin::kUser), name};
}

std::vector<double> rising_seconds(const ParsedTable& parsed, const UserTable& file) {
  std::vector<double> time = rising_times(parsed.table, parsed.name);
  for (double& t : time) t *= file.units.time;
  return time;
}

}  // namespace armtune::internal
