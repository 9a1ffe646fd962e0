#include "sim/scenario/planned_motion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "core/trajectory/cubic_spline.hpp"
#include "core/trajectory/linear_acceleration.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/motion_rows.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/trajectory_message.hpp"

namespace armtune::internal {
namespace {

/// How far a row may lie beside the motion of the rows before it, in position [rad, m] and velocity [rad/s,
/// m/s]: what numbers of six digits leave.
constexpr double kPositionJump = 1e-5;
constexpr double kVelocityJump = 1e-4;
/// A planner's limits hold but for its own tolerance [rad, m].
constexpr double kBeyondLimit = 1e-6;
constexpr const char* kToNext = " and the next point, between them";

std::string name_of(const JointInfo& joint, const char* what) {
  return "joint/" + joint.name + "/" + what;
}

/// The column of a joint's positions.
std::size_t position_column(const CsvTable& table, const JointInfo& joint) {
  const auto plain = table.find(joint.name);
  return plain && !table.find(name_of(joint, "position")) ? *plain : table.column(name_of(joint, "position"));
}

/// What makes a joint's numbers SI.
JointVector factors_of(const yaml::FileUnits& units, const RobotModel& robot) {
  JointVector factors(robot.n());
  for (int i = 0; i < robot.n(); ++i)
    factors[i] = robot.chain.motion[static_cast<std::size_t>(i)] == JointMotion::kPrismatic ? units.length
                                                                                            : units.angle;
  return factors;
}

/// A number for each joint out of a row.
JointVector numbers_of(const ParsedTable& parsed, std::size_t row, const std::vector<std::size_t>& columns) {
  JointVector numbers(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i)
    numbers[static_cast<Eigen::Index>(i)] = finite_cell(parsed.table, row, columns[i], parsed.name);
  return numbers;
}

/// What the columns of a table give: velocities of every joint, or of none.
PointsGive given_in(const CsvTable& table, const RobotModel& robot) {
  const auto any = [&](const char* what) {
    return std::any_of(robot.joints.begin(), robot.joints.end(),
                       [&](const JointInfo& joint) { return table.find(name_of(joint, what)).has_value(); });
  };
  if (any("acceleration")) return PointsGive::kAccelerations;
  return any("velocity") ? PointsGive::kVelocities : PointsGive::kPositions;
}

MotionPoints read_rows(const UserTable& file, const RobotModel& robot) {
  const ParsedTable parsed = parse_user_table(file, ColumnNames::kAsWritten, "planned",
                                              fmt::format("time, {}", fmt::join(joint_names(robot), ", ")));
  const CsvTable& table = parsed.table;
  MotionPoints motion;
  motion.time = rising_seconds(parsed, file);
  motion.given = given_in(table, robot);
  const JointVector factors = factors_of(file.units, robot);
  std::vector<std::size_t> position, velocity, acceleration;
  for (const JointInfo& joint : robot.joints) {
    position.push_back(position_column(table, joint));
    if (motion.given != PointsGive::kPositions) velocity.push_back(table.column(name_of(joint, "velocity")));
    if (motion.given == PointsGive::kAccelerations)
      acceleration.push_back(table.column(name_of(joint, "acceleration")));
  }
  const auto read = [&](std::size_t row, const std::vector<std::size_t>& columns) {
    return columns.empty() ? JointVector(JointVector::Zero(robot.n()))
                           : JointVector(factors.cwiseProduct(numbers_of(parsed, row, columns)));
  };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    motion.points.push_back({read(row, position), read(row, velocity), read(row, acceleration)});
    motion.where.push_back(fmt::format("{}:{}", parsed.name, line_of(row)));
  }
  return motion;
}

void check_position(const JointInfo& joint, double q, const std::string& where) {
  if (!joint.limits.has_position) return;
  if (q >= joint.limits.lower - kBeyondLimit && q <= joint.limits.upper + kBeyondLimit) return;
  const double from_degrees = q * std::numbers::pi / 180.0;
  const bool degrees = std::abs(q) > 2.0 * std::numbers::pi && from_degrees >= joint.limits.lower &&
                       from_degrees <= joint.limits.upper;
  throw InputError(
      fmt::format("{}: joint/{}/position is {:.9g}, outside the joint's limits {:.6g} .. {:.6g}; {}", where,
                  joint.name, q, joint.limits.lower, joint.limits.upper,
                  degrees ? "if the file has degrees, say so: planned: {file: ..., units: {angle: deg}}"
                          : "plan for this robot"));
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
                     knot.position[i] + s * (v + s * (a / 2.0 + s * j / 6.0)), where);
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

/// Between points the motion may swing out: looked at so many times.
constexpr int kLooks = 32;

void check_segments(const RobotModel& robot, const JointSpline& motion, const MotionPoints& points) {
  for (std::size_t k = 0; k + 1 < points.time.size(); ++k) {
    const double h = points.time[k + 1] - points.time[k];
    for (int look = 1; look < kLooks; ++look) {
      const JointVector q = motion.at(points.time[k] + h * look / kLooks).position;
      for (int i = 0; i < robot.n(); ++i)
        check_position(robot.joints[static_cast<std::size_t>(i)], q[i], points.where[k] + kToNext);
    }
  }
}

/// Acceleration that is linear between points.
JointSpline smooth(MotionPoints motion, const RobotModel& robot) {
  const bool of_waypoints = motion.given == PointsGive::kPositions;
  if (of_waypoints) {
    std::vector<JointVector> positions;
    positions.reserve(motion.points.size());
    for (const MotionPoint<JointVector>& point : motion.points) positions.push_back(point.position);
    motion.points = cubic_spline(motion.time, positions);
  }
  for (std::size_t k = 0; k + 1 < motion.time.size(); ++k) {
    const double h = motion.time[k + 1] - motion.time[k];
    const MotionPoint<JointVector>& next = motion.points[k + 1];
    if (of_waypoints)
      check_between(robot, motion.points[k], next.acceleration, h, motion.where[k] + kToNext);
    else
      check_step(robot, motion.points[k], next, h, motion.where[k + 1]);
  }
  return {std::move(motion.time), std::move(motion.points)};
}

}  // namespace

PlannedFile read_planned_node(const yaml::Node& node) {
  if (node.kind() != yaml::Node::Kind::kMap) return {{file_beside(node.as_string(), node.file())}};
  yaml::MapReader map(node);
  PlannedFile file;
  file.table = read_user_table(map, "time angle length");
  if (const yaml::Node* segments = map.optional("segments")) {
    file.as_ros = segments->is_word("as_ros");
    if (!file.as_ros)
      segments->fail(
          fmt::format("'{}' is not as_ros; leave the key out for a smooth motion", segments->as_string()));
  }
  map.finish();
  return file;
}

JointSpline load_planned_motion(const PlannedFile& file, const RobotModel& robot) {
  const bool message = is_trajectory_message(file.table.path);
  MotionPoints motion =
      message ? load_trajectory_message(file.table.path, robot) : read_rows(file.table, robot);
  for (std::size_t k = 0; k < motion.time.size(); ++k) {
    for (int i = 0; i < robot.n(); ++i)
      check_position(robot.joints[static_cast<std::size_t>(i)], motion.points[k].position[i],
                     motion.where[k]);
  }
  if (!file.as_ros && !message && motion.given != PointsGive::kVelocities)
    return smooth(std::move(motion), robot);
  JointSpline joined(motion.time, motion.points, motion.given);
  check_segments(robot, joined, motion);
  return joined;
}

}  // namespace armtune::internal
