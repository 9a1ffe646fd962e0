#include "sim/scenario/planned_motion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "core/trajectory/cubic_spline.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/motion_checks.hpp"
#include "sim/scenario/motion_rows.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/trajectory_message.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMostRows = 200'000;  // 100 s at 2 kHz; each row takes about 1 kB
constexpr double kSlowest = 0.01;           // factors on the speed
constexpr double kFastest = 10.0;

std::string name_of(const JointInfo& joint, const char* what) {
  return "joint/" + joint.name + "/" + what;
}

/// Returns the column of a joint's positions.
std::size_t position_column(const CsvTable& table, const JointInfo& joint) {
  const auto plain = table.find(joint.name);
  return plain && !table.find(name_of(joint, "position")) ? *plain : table.column(name_of(joint, "position"));
}

/// Returns the factors (n) that convert the numbers of the joints to SI units.
JointVector factors_of(const yaml::FileUnits& units, const RobotModel& robot) {
  JointVector factors(robot.n());
  for (int i = 0; i < robot.n(); ++i)
    factors[i] = robot.chain.motion[static_cast<std::size_t>(i)] == JointMotion::kPrismatic ? units.length
                                                                                            : units.angle;
  return factors;
}

/// Returns one number for each joint from a row.
JointVector numbers_of(const ParsedTable& parsed, std::size_t row, const std::vector<std::size_t>& columns) {
  JointVector numbers(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i)
    numbers[static_cast<Eigen::Index>(i)] = finite_cell(parsed.table, row, columns[i], parsed.name);
  return numbers;
}

/// Returns the quantities that the table gives for at least one joint. It must give them for all joints.
PointsGive given_in(const CsvTable& table, const RobotModel& robot) {
  const auto any = [&](const char* what) {
    return std::any_of(robot.joints.begin(), robot.joints.end(),
                       [&](const JointInfo& joint) { return table.find(name_of(joint, what)).has_value(); });
  };
  if (any("acceleration")) return PointsGive::kAccelerations;
  return any("velocity") ? PointsGive::kVelocities : PointsGive::kPositions;
}

/// True if the table has the positions of the joints and nothing else.
bool has_positions_only(const CsvTable& table, const RobotModel& robot) {
  return std::all_of(table.header().begin(), table.header().end(), [&](const std::string& column) {
    return std::any_of(robot.joints.begin(), robot.joints.end(), [&](const JointInfo& joint) {
      return column == joint.name || column == name_of(joint, "position");
    });
  });
}

MotionPoints read_rows(const UserTable& file, const RobotModel& robot) {
  const ParsedTable parsed = parse_user_table(file, ColumnNames::kAsWritten, "planned",
                                              fmt::format("time, {}", fmt::join(joint_names(robot), ", ")));
  const CsvTable& table = parsed.table;
  if (table.rows() > kMostRows)
    throw InputError(
        InputPlace{parsed.name},
        fmt::format("{} rows; a motion may have at most {}: use fewer rows", table.rows(), kMostRows))
        .with_value(std::to_string(table.rows()), fmt::format("at most {} rows", kMostRows));
  MotionPoints motion;
  motion.file = parsed.name;
  if (!has_positions_only(table, robot)) motion.time = rising_seconds(parsed, file);
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
    motion.lines.push_back(line_of(row));
  }
  return motion;
}

const char* hint_for_degrees(bool message) {
  return message
             ? "convert degrees: a JointTrajectory has radians"
             : "if the file is in degrees, declare this: units: {angle: deg} (for --trajectory: --degrees)";
}

/// Reads the points of a message, or the rows of a CSV file.
MotionPoints read_points(const PlannedFile& file, const RobotModel& robot) {
  if (!is_trajectory_message(file.table.path)) return read_rows(file.table, robot);
  if (file.table.is_described())
    throw InputError(
        InputPlace{file.table.path, 0, "units"},
        "'units' and 'columns' are for CSV files only; a JointTrajectory has seconds, radians and "
        "joint_names: leave both keys out")
        .with_value({}, "a CSV file");
  return load_trajectory_message(file.table.path, robot);
}

/// Adds velocities and accelerations: those of the cubic spline through the positions, at rest at both ends.
void make_smooth(MotionPoints& motion) {
  std::vector<JointVector> positions;
  positions.reserve(motion.points.size());
  for (const MotionPoint<JointVector>& point : motion.points) positions.push_back(point.position);
  motion.points = cubic_spline(motion.time, positions);
}

/// Changes the speed of the motion by a factor. The time of its first point stays.
void change_speed(double factor, MotionPoints& motion) {
  if (factor == 1.0) return;
  const double begin = motion.time.front();
  for (double& time : motion.time) time = begin + (time - begin) / factor;
  for (MotionPoint<JointVector>& point : motion.points) {
    point.velocity *= factor;
    point.acceleration *= factor * factor;
  }
}

JointSpline motion_of(const PlannedFile& file, MotionPoints motion, const RobotModel& robot) {
  const bool message = is_trajectory_message(file.table.path);
  const MotionChecks checks(robot, motion, hint_for_degrees(message));
  checks.at_points();
  checks.unlimited_joints(file.speed);
  if (file.segments == Segments::kNextPoint) {
    if (motion.given == PointsGive::kPositions)
      throw InputError(InputPlace{motion.file, 0, "velocities"},
                       "the points have no velocities, but a controller that does not interpolate between "
                       "points (interpolation_method: none) needs them; give the velocities of each point")
          .with_value({}, "velocities of each point");
    change_speed(file.speed, motion);
    return {std::move(motion.time), std::move(motion.points), motion.given, BetweenPoints::kNextPoint};
  }
  if (file.segments == Segments::kAsRos || message || motion.given == PointsGive::kVelocities) {
    checks.between_points(JointSpline(motion.time, motion.points, motion.given));
    change_speed(file.speed, motion);
    return {std::move(motion.time), std::move(motion.points), motion.given};
  }
  if (motion.given == PointsGive::kPositions) {
    make_smooth(motion);
    checks.between_knots();
  } else {
    checks.steps();
  }
  change_speed(file.speed, motion);
  return {std::move(motion.time), std::move(motion.points)};
}

std::vector<JointVector> goals_of(const PlannedFile& file, const MotionPoints& points,
                                  const RobotModel& robot) {
  const std::size_t count = points.points.size();
  if (count < 2)
    throw InputError(InputPlace{points.file},
                     "there is only one joint goal; give at least two. The arm starts at the first one")
        .with_value(std::to_string(count), "at least 2 joint goals");
  if (count > kMostGoals)
    throw InputError(
        InputPlace{points.file},
        fmt::format(
            "the file has {} joint goals without times, but a planned motion stops at each goal and can "
            "have at most {}; if these are points of one motion, give their times",
            count, kMostGoals))
        .with_value(std::to_string(count), fmt::format("at most {} joint goals", kMostGoals));
  MotionChecks(robot, points, hint_for_degrees(is_trajectory_message(file.table.path))).at_points();
  std::vector<JointVector> goals;
  goals.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const MotionPoint<JointVector>& point = points.points[k];
    if (!point.velocity.isZero(0.0) || !point.acceleration.isZero(0.0))
      throw InputError(points.where(k, "time_from_start"),
                       "the points have velocities or accelerations, but no times; give each point its time, "
                       "or leave the velocities and accelerations out")
          .with_value({}, "a time for each point");
    // A goal at a rounded limit may exceed the limit by the last digit.
    goals.emplace_back(point.position.cwiseMax(robot.lower_limits()).cwiseMin(robot.upper_limits()));
  }
  return goals;
}

}  // namespace

PlannedFile read_planned_node(const yaml::Node& node) {
  if (node.kind() != yaml::Node::Kind::kMap) return {{file_beside(node.as_string(), node.file())}};
  yaml::MapReader map(node);
  PlannedFile file;
  file.table = read_user_table(map, "time angle length");
  if (const yaml::Node* segments = map.optional("segments")) {
    if (!segments->is_word("as_ros") && !segments->is_word("next_point"))
      segments->fail(
          fmt::format(
              "'{}' is not valid; give as_ros or next_point, or leave the key out for a smooth motion",
              segments->as_string()),
          "as_ros or next_point");
    file.segments = segments->is_word("as_ros") ? Segments::kAsRos : Segments::kNextPoint;
  }
  file.speed = map.number_in("speed", 1.0, kSlowest, kFastest);
  map.finish();
  return file;
}

JointSpline load_planned_motion(const PlannedFile& file, const RobotModel& robot) {
  MotionPoints points = read_points(file, robot);
  if (points.time.empty())
    throw is_trajectory_message(file.table.path)
        ? InputError(InputPlace{points.file, 0, "time_from_start"},
                     "no point has a time_from_start above 0; give each point its time")
        : InputError(InputPlace{points.file, 0, "time"},
                     "no column 'time'; give the time of each row in seconds");
  return motion_of(file, std::move(points), robot);
}

MotionOrGoals load_motion_or_goals(const PlannedFile& file, const RobotModel& robot) {
  MotionPoints points = read_points(file, robot);
  if (points.time.empty()) return {std::nullopt, goals_of(file, points, robot)};
  return {motion_of(file, std::move(points), robot), {}};
}

}  // namespace armtune::internal
