#include "sim/scenario/waypoints_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <vector>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/common/message_text.hpp"
#include "core/trajectory/cubic_spline.hpp"
#include "sim/csv/csv_parts.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/csv/line_cells.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/motion_rows.hpp"
#include "sim/yaml/map_reader.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMostWaypoints = 20000;
constexpr double kFastest = 1e6;  // m/s, m/s^2: beyond it is no motion of an arm
constexpr double kUnit = 1e-3;    // by which a quaternion's length may miss 1
constexpr std::array kPlace{"x", "y", "z"};
constexpr std::array kTurn{"qw", "qx", "qy", "qz"};

template <std::size_t N>
bool is_one_of(const std::array<const char*, N>& names, const std::string& name) {
  return std::any_of(names.begin(), names.end(), [&](const char* one) { return name == one; });
}

constexpr std::size_t kMostBytes = 48U << 20;

/// The text with commas between its cells, whatever stands there, and the names of its first line in lower
/// case. Throws InputError for a number with a comma in it.
std::string with_commas(std::string_view text, const std::string& path) {
  std::string result;
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
    split_cells(line, separator, cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].find(',') != std::string_view::npos) {
        throw InputError(fmt::format(
            "{}:{}: the cell {} of this file, whose cells are separated by {}, has a comma; write numbers with a point",
            path, number, shown(std::string(cells[i])), separator_name(separator)));
      }
      result += i > 0 ? "," : "";
      result += cells[i];
    }
    if (number == 1) {
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

/// Whether the first line of a table with commas holds numbers and no names.
bool has_no_names(const std::string& text) {
  std::vector<std::string_view> cells;
  split_cells(std::string_view(text).substr(0, text.find('\n')), ',', cells);
  return std::all_of(cells.begin(), cells.end(), is_number);
}

/// A table with its names, and what messages call it.
struct NamedTable {
  CsvTable table;
  std::string name;
};

NamedTable parse_table(const Waypoints& waypoints) {
  const std::string& path = waypoints.path;
  std::string text = with_commas(read_input_file(path, kMostBytes, "a CSV file"), path);
  std::string name = path;
  if (has_no_names(text)) {
    if (waypoints.columns.empty()) {
      throw InputError(fmt::format(
          "{}:1: the first line holds numbers and no names; add a line of names, or say where the file is "
          "named which column is which: waypoints: {{file: {}, columns: [time, x, y, z]}}",
          path, yaml::quoted(std::filesystem::path(path).filename().string())));
    }
    text = fmt::format("{}\n{}", fmt::join(waypoints.columns, ","), text);
    name += " (below a line of names)";
  } else if (!waypoints.columns.empty()) {
    throw InputError(
        fmt::format("{}:1: the first line holds names; leave 'columns' out, or take that line away", path));
  }
  return {CsvTable::parse(text, name, CsvOrigin::kUser), name};
}

NamedTable read_table(const Waypoints& waypoints) {
  NamedTable named = parse_table(waypoints);
  const CsvTable& table = named.table;
  const std::string& path = named.name;
  for (const std::string& column : table.header()) {
    if (column == "time" || is_one_of(kPlace, column) || is_one_of(kTurn, column)) continue;
    throw InputError(
        fmt::format("{}: column {} is none of waypoints, which are time, x, y, z, and of a tool qw, qx, qy, "
                    "qz; take it out",
                    path, shown(column)));
  }
  if (table.rows() > kMostWaypoints)
    throw InputError(
        fmt::format("{}: {} rows; a path has at most {}: thin them out", path, table.rows(), kMostWaypoints));
  return named;
}

/// Times in the table's unit, in seconds.
std::vector<double> seconds(const NamedTable& named, const Waypoints& waypoints) {
  std::vector<double> time = rising_times(named.table, named.name);
  for (double& t : time) t *= waypoints.units.time;
  return time;
}

/// These columns of every row.
template <std::size_t N>
std::vector<std::array<double, N>> numbers(const CsvTable& table, const std::array<const char*, N>& names,
                                           const std::string& path) {
  std::array<std::size_t, N> columns{};
  for (std::size_t i = 0; i < N; ++i) columns[i] = table.column(names[i]);
  std::vector<std::array<double, N>> rows(table.rows());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t i = 0; i < N; ++i) rows[row][i] = finite_cell(table, row, columns[i], path);
  }
  return rows;
}

}  // namespace

Waypoints read_waypoints_node(const yaml::Node& node) {
  Waypoints waypoints;
  if (node.kind() != yaml::Node::Kind::kMap) {
    waypoints.path = file_beside(node.as_string(), node.file());
    return waypoints;
  }
  yaml::MapReader map(node);
  const yaml::Node& file = map.required("file");
  waypoints.path = file_beside(file.as_string(), file.file());
  if (const yaml::Node* units = map.optional("units"))
    waypoints.units = yaml::read_file_units(*units, "time length");
  if (const yaml::Node* columns = map.optional("columns")) waypoints.columns = columns->as_strings();
  map.finish();
  return waypoints;
}

PositionSpline load_waypoints(const Waypoints& waypoints, bool of_poses) {
  const NamedTable named = read_table(waypoints);
  const CsvTable& table = named.table;
  const std::string& path = named.name;
  for (const std::string& column : table.header()) {
    if (of_poses || !is_one_of(kTurn, column)) continue;
    throw InputError(fmt::format(
        "{}: column {} is of a tool's orientation; say 'orientation: {{waypoints: ...}}' of the same file, "
        "where this is the tool's path, or take the column out",
        path, column));
  }
  const std::vector<double> time = seconds(named, waypoints);
  std::vector<Vec3> positions;
  positions.reserve(table.rows());
  for (const auto& row : numbers(table, kPlace, path))
    positions.push_back(waypoints.units.length * Vec3(row.data()));
  const auto knots = cubic_spline(time, positions);
  for (std::size_t k = 0; k < knots.size(); ++k) {
    if (knots[k].velocity.norm() <= kFastest && knots[k].acceleration.norm() <= kFastest) continue;
    throw InputError(fmt::format(
        "{}:{}: the way here asks for {:.3g} m/s and {:.3g} m/s^2; at most {:.0e} of both: give it "
        "more time",
        path, line_of(k), knots[k].velocity.norm(), knots[k].acceleration.norm(), kFastest));
  }
  return {time, knots, false};
}

ToolOrientation load_orientations(const Waypoints& waypoints) {
  const NamedTable named = read_table(waypoints);
  const CsvTable& table = named.table;
  const std::string& path = named.name;
  const std::vector<double> time = seconds(named, waypoints);
  std::vector<Eigen::Quaterniond> orientations;
  orientations.reserve(table.rows());
  for (const auto& row : numbers(table, kTurn, path)) {
    const Eigen::Quaterniond q(row[0], row[1], row[2], row[3]);
    const double length = q.coeffs().stableNorm();
    if (!(std::abs(length - 1.0) <= kUnit)) {
      throw InputError(fmt::format("{}:{}: the quaternion has length {:.6g}; that of an orientation is 1",
                                   path, line_of(orientations.size()), length));
    }
    orientations.push_back(q.normalized());
  }
  ToolOrientation turning = turning_through(time, orientations);
  for (std::size_t k = 0; k < time.size(); ++k) {
    const MotionPoint<Vec3>& knot = turning.turn->knots()[k];
    if (!(knot.position.norm() <= kMostTurn)) {
      throw InputError(
          fmt::format("{}:{}: the tool has turned by {:.3g} rad since the first row; it may by "
                      "{:.3g}: turn it back in between",
                      path, line_of(k), knot.position.norm(), kMostTurn));
    }
    if (!(knot.velocity.norm() <= kFastest && knot.acceleration.norm() <= kFastest)) {
      throw InputError(
          fmt::format("{}:{}: the turn here asks for {:.3g} rad/s and {:.3g} rad/s^2; at most {:.0e} of "
                      "both: give it more time",
                      path, line_of(k), knot.velocity.norm(), knot.acceleration.norm(), kFastest));
    }
  }
  return turning;
}

}  // namespace armtune::internal
