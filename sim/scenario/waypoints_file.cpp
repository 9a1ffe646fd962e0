#include "sim/scenario/waypoints_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"
#include "core/trajectory/cubic_spline.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/motion_rows.hpp"
#include "sim/scenario/trajectory_message.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMostWaypoints = 20000;
constexpr double kFastest = 1e6;  // m/s, m/s^2: no arm moves faster
constexpr double kUnit = 1e-3;    // largest difference of a quaternion's length from 1
constexpr std::array kPlace{"x", "y", "z"};
constexpr std::array kTurn{"qw", "qx", "qy", "qz"};

template <std::size_t N>
bool is_one_of(const std::array<const char*, N>& names, const std::string& name) {
  return std::any_of(names.begin(), names.end(), [&](const char* one) { return name == one; });
}

ParsedTable read_table(const UserTable& waypoints) {
  ParsedTable named = parse_user_table(waypoints, ColumnNames::kInLowerCase, "waypoints", "time, x, y, z");
  const CsvTable& table = named.table;
  const std::string& path = named.name;
  for (const std::string& column : table.header()) {
    if (column == "time" || is_one_of(kPlace, column) || is_one_of(kTurn, column)) continue;
    throw InputError(
        at_line(path, 1, column),
        fmt::format("column {} is not one of time, x, y, z or, for the tool's orientation, qw, qx, qy, "
                    "qz; take it out",
                    shown(column)))
        .with_value(column, "one of: time, x, y, z, qw, qx, qy, qz");
  }
  if (table.rows() > kMostWaypoints)
    throw InputError(InputPlace{path}, fmt::format("{} rows; a path may have at most {}: use fewer rows",
                                                   table.rows(), kMostWaypoints))
        .with_value(std::to_string(table.rows()), fmt::format("at most {} rows", kMostWaypoints));
  return named;
}

/// Returns the numbers in these columns, row by row.
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

UserTable read_waypoints_node(const yaml::Node& node) {
  if (node.kind() != yaml::Node::Kind::kMap) return {file_beside(node.as_string(), node.file())};
  yaml::MapReader map(node);
  UserTable waypoints = read_user_table(map, "time length");
  map.finish();
  return waypoints;
}

bool has_tool_waypoints(const UserTable& file, const RobotModel& robot) {
  if (is_trajectory_message(file.path)) return false;
  try {
    const ParsedTable named = parse_user_table(file, ColumnNames::kInLowerCase, "waypoints", "time, x, y, z");
    const std::vector<std::string> joints = joint_names(robot);
    return std::all_of(kPlace.begin(), kPlace.end(), [&](const char* name) {
      return named.table.find(name) && std::find(joints.begin(), joints.end(), name) == joints.end();
    });
  } catch (const InputError&) {
    return false;  // whoever reads it as a joint motion says why
  }
}

bool has_orientations(const UserTable& waypoints) {
  const ParsedTable named = read_table(waypoints);
  return std::any_of(kTurn.begin(), kTurn.end(),
                     [&named](const char* name) { return named.table.find(name).has_value(); });
}

PositionSpline load_waypoints(const UserTable& waypoints, bool of_poses) {
  const ParsedTable named = read_table(waypoints);
  const CsvTable& table = named.table;
  const std::string& path = named.name;
  for (const std::string& column : table.header()) {
    if (of_poses || !is_one_of(kTurn, column)) continue;
    throw InputError(
        at_line(path, 1, column),
        fmt::format(
            "column {} gives the tool's orientation, which is not used here; if the file is the tool's path, add "
            "'orientation: {{waypoints: ...}}' with the same file, otherwise remove the column",
            column))
        .with_value(column, "one of: time, x, y, z");
  }
  const std::vector<double> time = rising_seconds(named, waypoints);
  std::vector<Vec3> positions;
  positions.reserve(table.rows());
  for (const auto& row : numbers(table, kPlace, path))
    positions.push_back(waypoints.units.length * Vec3(row.data()));
  const auto knots = cubic_spline(time, positions);
  for (std::size_t k = 0; k < knots.size(); ++k) {
    if (knots[k].velocity.norm() <= kFastest && knots[k].acceleration.norm() <= kFastest) continue;
    throw InputError(
        at_line(path, line_of(k)),
        fmt::format(
            "the path has {:.3g} m/s and {:.3g} m/s^2 here; at most {:.0e} of each is allowed: leave more "
            "time between the rows",
            knots[k].velocity.norm(), knots[k].acceleration.norm(), kFastest))
        .with_value({}, fmt::format("at most {:.0e} m/s and m/s^2", kFastest));
  }
  return {time, knots, false};
}

ToolOrientation load_orientations(const UserTable& waypoints) {
  const ParsedTable named = read_table(waypoints);
  const CsvTable& table = named.table;
  const std::string& path = named.name;
  const std::vector<double> time = rising_seconds(named, waypoints);
  std::vector<Eigen::Quaterniond> orientations;
  orientations.reserve(table.rows());
  for (const auto& row : numbers(table, kTurn, path)) {
    const Eigen::Quaterniond q(row[0], row[1], row[2], row[3]);
    const double length = q.coeffs().stableNorm();
    if (!(std::abs(length - 1.0) <= kUnit)) {
      throw InputError(at_line(path, line_of(orientations.size())),
                       fmt::format("the quaternion has length {:.6g}; it must have length 1", length))
          .with_value(fmt::format("{:.6g}", length), "a quaternion of length 1");
    }
    orientations.push_back(q.normalized());
  }
  ToolOrientation turning = turning_through(time, orientations);
  for (std::size_t k = 0; k < time.size(); ++k) {
    const MotionPoint<Vec3>& knot = turning.turn->knots()[k];
    if (!(knot.position.norm() <= kMostTurn)) {
      throw InputError(
          at_line(path, line_of(k)),
          fmt::format("the tool has turned by {:.3g} rad since the first row; at most {:.3g} rad is "
                      "allowed: turn it back in between",
                      knot.position.norm(), kMostTurn))
          .with_value(fmt::format("{:.3g}", knot.position.norm()),
                      fmt::format("at most {:.3g} rad", kMostTurn));
    }
    if (!(knot.velocity.norm() <= kFastest && knot.acceleration.norm() <= kFastest)) {
      throw InputError(
          at_line(path, line_of(k)),
          fmt::format(
              "the rotation has {:.3g} rad/s and {:.3g} rad/s^2 here; at most {:.0e} of each is allowed: "
              "leave more time between the rows",
              knot.velocity.norm(), knot.acceleration.norm(), kFastest))
          .with_value({}, fmt::format("at most {:.0e} rad/s and rad/s^2", kFastest));
    }
  }
  return turning;
}

}  // namespace armtune::internal
