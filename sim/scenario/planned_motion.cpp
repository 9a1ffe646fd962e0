#include "sim/scenario/planned_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"
#include "core/trajectory/cubic_spline.hpp"
#include "core/trajectory/linear_acceleration.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/scenario/motion_rows.hpp"

namespace armtune::internal {
namespace {

/// How far a row may lie beside the motion of the rows before it, in position [rad, m] and velocity [rad/s,
/// m/s]: what numbers of six digits leave.
constexpr double kPositionJump = 1e-5;
constexpr double kVelocityJump = 1e-4;
/// A planner's limits hold but for its own tolerance [rad, m].
constexpr double kBeyondLimit = 1e-6;

std::string name_of(const JointInfo& joint, const char* what) {
  return "joint/" + joint.name + "/" + what;
}

/// A column for each joint.
std::vector<std::size_t> columns_of(const CsvTable& table, const RobotModel& robot, const char* what) {
  std::vector<std::size_t> columns;
  columns.reserve(robot.joints.size());
  for (const JointInfo& joint : robot.joints) columns.push_back(table.column(name_of(joint, what)));
  return columns;
}

JointVector numbers_of(const CsvTable& table, std::size_t row, const std::vector<std::size_t>& columns,
                       const std::string& path) {
  JointVector numbers(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i)
    numbers[static_cast<Eigen::Index>(i)] = finite_cell(table, row, columns[i], path);
  return numbers;
}

/// Whether the file has no column but positions of any of the joints.
bool has_positions_only(const CsvTable& table, const RobotModel& robot) {
  return std::none_of(robot.joints.begin(), robot.joints.end(), [&table](const JointInfo& joint) {
    return table.find(name_of(joint, "velocity")) || table.find(name_of(joint, "acceleration"));
  });
}

void check_position(const JointInfo& joint, double q, const std::string& where) {
  if (!joint.limits.has_position) return;
  if (q >= joint.limits.lower - kBeyondLimit && q <= joint.limits.upper + kBeyondLimit) return;
  throw InputError(
      fmt::format("{}: joint/{}/position is {:.9g}, outside the joint's limits {:.6g} .. {:.6g}; plan "
                  "for this robot",
                  where, joint.name, q, joint.limits.lower, joint.limits.upper));
}

/// Where each joint turns round between two knots, h [s] apart, its position is within its limits.
void check_between(const RobotModel& robot, const MotionPoint<JointVector>& knot,
                   const JointVector& next_acceleration, double h, const std::string& where) {
  for (int i = 0; i < robot.n(); ++i) {
    // v + a s + j s^2 / 2 = 0, in the form that divides by no small number.
    const double v = knot.velocity[i], a = knot.acceleration[i], j = (next_acceleration[i] - a) / h;
    const double root = std::sqrt(std::max(0.0, a * a - 2.0 * j * v));
    const double q = -(a + std::copysign(root, a));
    for (const double s : {q / j, 2.0 * v / q}) {
      if (!(s > 0.0 && s < h)) continue;
      check_position(robot.joints[static_cast<std::size_t>(i)],
                     knot.position[i] + s * (v + s * (a / 2.0 + s * j / 6.0)), where + ", between them");
    }
  }
}

/// The row against the motion from the row before it.
void check_step(const RobotModel& robot, const MotionPoint<JointVector>& before,
                const MotionPoint<JointVector>& row, double h, const std::string& where) {
  const MotionPoint<JointVector> expected = linear_acceleration(before, row.acceleration, h, h);
  for (int i = 0; i < robot.n(); ++i) {
    const std::string& joint = robot.joints[static_cast<std::size_t>(i)].name;
    const auto check = [&](const char* what, double value, double wanted, double most) {
      if (std::abs(value - wanted) <= most) return;
      throw InputError(
          fmt::format("{}: joint/{}/{} is {:.9g}, {:.3g} beside the motion from the row before, whose "
                      "acceleration is linear "
                      "between rows; at most {:g}: give more rows, more digits, or accelerations that fit",
                      where, joint, what, value, std::abs(value - wanted), most));
    };
    check("position", row.position[i], expected.position[i], kPositionJump);
    check("velocity", row.velocity[i], expected.velocity[i], kVelocityJump);
  }
}

}  // namespace

JointSpline load_planned_motion(const std::string& path, const RobotModel& robot) {
  const CsvTable table = CsvTable::read(path, CsvOrigin::kUser);
  std::vector<double> time = rising_times(table, path);
  const auto where = [&path](std::size_t row) { return fmt::format("{}:{}", path, line_of(row)); };
  std::vector<JointVector> positions;
  positions.reserve(table.rows());
  const auto columns = columns_of(table, robot, "position");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    positions.push_back(numbers_of(table, row, columns, path));
    for (int i = 0; i < robot.n(); ++i)
      check_position(robot.joints[static_cast<std::size_t>(i)], positions[row][i], where(row));
  }
  if (has_positions_only(table, robot)) {
    auto knots = cubic_spline(time, positions);
    for (std::size_t k = 0; k + 1 < knots.size(); ++k)
      check_between(robot, knots[k], knots[k + 1].acceleration, time[k + 1] - time[k],
                    fmt::format("{} and {}", where(k), line_of(k + 1)));
    return {std::move(time), std::move(knots)};
  }
  const auto velocities = columns_of(table, robot, "velocity");
  const auto accelerations = columns_of(table, robot, "acceleration");
  std::vector<MotionPoint<JointVector>> knots;
  knots.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    MotionPoint<JointVector> knot{positions[row], numbers_of(table, row, velocities, path),
                                  numbers_of(table, row, accelerations, path)};
    if (row > 0) check_step(robot, knots.back(), knot, time[row] - time[row - 1], where(row));
    knots.push_back(std::move(knot));
  }
  return {std::move(time), std::move(knots)};
}

}  // namespace armtune::internal
