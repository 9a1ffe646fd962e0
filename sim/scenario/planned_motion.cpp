#include "sim/scenario/planned_motion.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/common/error.hpp"
#include "core/trajectory/linear_acceleration.hpp"
#include "sim/csv/csv_table.hpp"

namespace armtune {
namespace {

/// How far a row may lie beside the motion of the rows before it, in position [rad, m] and velocity [rad/s,
/// m/s]: what numbers of six digits leave.
constexpr double kPositionJump = 1e-5;
constexpr double kVelocityJump = 1e-4;
/// A planner's limits hold but for its own tolerance [rad, m].
constexpr double kBeyondLimit = 1e-6;

/// Line of the file that a row of the table stands in.
std::size_t line_of(std::size_t row) {
  return row + 2;
}

double finite(const CsvTable& table, std::size_t row, std::size_t column, const std::string& path) {
  const double value = table.number(row, column);
  if (std::isfinite(value)) return value;
  throw InputError(fmt::format("{}:{}: {} in column {} is no finite number; a plan has one in every row",
                               path, line_of(row), shown(table.text(row, column)), table.header()[column]));
}

std::vector<double> read_times(const CsvTable& table, const std::string& path) {
  const std::size_t column = table.column("time");
  std::vector<double> time;
  time.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    time.push_back(finite(table, row, column, path));
    if (row == 0 && time[0] < 0.0) {
      throw InputError(
          fmt::format("{}:{}: time is {} s; a scenario's clock has nothing before 0 s: shift the plan", path,
                      line_of(row), time[0]));
    }
    if (row == 0 || time[row] > time[row - 1]) continue;
    throw InputError(fmt::format("{}:{}: time {} s does not rise after {} s; each row must be later", path,
                                 line_of(row), time[row], time[row - 1]));
  }
  if (time.size() < 2) {
    throw InputError(fmt::format("{}: {} rows; a motion needs at least two", path, time.size()));
  }
  return time;
}

struct JointColumns {
  std::size_t position, velocity, acceleration;
};

JointColumns columns_of(const CsvTable& table, const std::string& joint) {
  const std::string tree = "joint/" + joint + "/";
  return {table.column(tree + "position"), table.column(tree + "velocity"),
          table.column(tree + "acceleration")};
}

void check_position(const JointInfo& joint, double q, const std::string& where) {
  if (!joint.limits.has_position) return;
  if (q >= joint.limits.lower - kBeyondLimit && q <= joint.limits.upper + kBeyondLimit) return;
  throw InputError(
      fmt::format("{}: joint/{}/position is {:.9g}, outside the joint's limits {:.6g} .. {:.6g}; plan "
                  "for this robot",
                  where, joint.name, q, joint.limits.lower, joint.limits.upper));
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
  std::vector<double> time = read_times(table, path);
  const int n = robot.n();
  std::vector<JointColumns> columns;
  columns.reserve(robot.joints.size());
  for (const JointInfo& joint : robot.joints) columns.push_back(columns_of(table, joint.name));
  std::vector<MotionPoint<JointVector>> knots;
  knots.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string where = fmt::format("{}:{}", path, line_of(row));
    MotionPoint<JointVector> knot{JointVector(n), JointVector(n), JointVector(n)};
    for (int i = 0; i < n; ++i) {
      const JointColumns& joint = columns[static_cast<std::size_t>(i)];
      knot.position[i] = finite(table, row, joint.position, path);
      knot.velocity[i] = finite(table, row, joint.velocity, path);
      knot.acceleration[i] = finite(table, row, joint.acceleration, path);
      check_position(robot.joints[static_cast<std::size_t>(i)], knot.position[i], where);
    }
    if (row > 0) check_step(robot, knots.back(), knot, time[row] - time[row - 1], where);
    knots.push_back(std::move(knot));
  }
  return {std::move(time), std::move(knots)};
}

}  // namespace armtune
