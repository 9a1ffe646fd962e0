#include "sim/scenario/waypoints_file.hpp"

#include <fmt/format.h>

#include "core/common/error.hpp"
#include "core/common/message_text.hpp"
#include "core/trajectory/cubic_spline.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/scenario/motion_rows.hpp"

namespace armtune {
namespace {

constexpr std::size_t kMostWaypoints = 20000;
constexpr double kFastest = 1e6;  // m/s, m/s^2: beyond it is no motion of an arm

}  // namespace

PositionSpline load_waypoints(const std::string& path) {
  const CsvTable table = CsvTable::read(path, CsvOrigin::kUser);
  for (const std::string& column : table.header()) {
    if (column == "time" || column == "x" || column == "y" || column == "z") continue;
    throw InputError(
        fmt::format("{}: column {} is none of a path's waypoints, which are time, x, y, z; take it out", path,
                    shown(column)));
  }
  if (table.rows() > kMostWaypoints)
    throw InputError(
        fmt::format("{}: {} rows; a path has at most {}: thin them out", path, table.rows(), kMostWaypoints));
  const std::vector<double> time = rising_times(table, path);
  const std::size_t columns[] = {table.column("x"), table.column("y"), table.column("z")};
  std::vector<Vec3> positions;
  positions.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    Vec3& position = positions.emplace_back();
    for (int axis = 0; axis < 3; ++axis) position[axis] = finite_cell(table, row, columns[axis], path);
  }
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

}  // namespace armtune
