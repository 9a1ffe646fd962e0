#include "tuner/controller_study/tool_path.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "sim/scenario/motion_rows.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/start_of_task.hpp"
#include "sim/scenario/task_trouble.hpp"
#include "sim/scenario/waypoints_file.hpp"

namespace armtune::internal {
namespace {

constexpr double kRestAfterPath = 0.5;  // s
constexpr int kPeriodsAtStart = 2;      // in which the joints hold the start; then the law tracks the tool

/// Returns the text of the waypoints, whose times begin at kRestBeforePath.
std::string later_waypoints(const ToolWaypoints& waypoints, bool turns) {
  const ParsedTable parsed =
      parse_user_table(waypoints.file, ColumnNames::kInLowerCase, "waypoints", "time, x, y, z");
  const std::vector<double> time = rising_seconds(parsed, waypoints.file);
  std::vector<std::string> names = {"x", "y", "z"};
  if (turns) names.insert(names.end(), {"qw", "qx", "qy", "qz"});
  std::string text = "time";
  std::vector<std::size_t> columns;
  for (const std::string& name : names) {
    text += "," + name;
    columns.push_back(parsed.table.column(name));
  }
  text += "\n";
  for (std::size_t row = 0; row < time.size(); ++row) {
    text += fmt::format("{}", kRestBeforePath + (time[row] - time.front()) / waypoints.speed);
    for (const std::size_t column : columns)
      text += fmt::format(",{}", finite_cell(parsed.table, row, column, parsed.name));
    text += "\n";
  }
  return text;
}

/// Returns the text of a joint motion that rests at q (n) for a few periods.
std::string resting_joints(const RobotModel& robot, const JointVector& q, double period) {
  std::string text = "time", row;
  for (const std::string& joint : joint_names(robot)) text += "," + joint;
  for (const double position : q) row += fmt::format(",{}", position);
  return fmt::format("{0}\n0{1}\n{2}{1}\n", text, row, kPeriodsAtStart * period);
}

}  // namespace

Scenario task_along(const ToolWaypoints& waypoints) {
  Scenario task;
  task.name = waypoints.robot->name;
  task.source = waypoints.file.path;
  task.robot = waypoints.robot;
  task.clearance = waypoints.clearance;
  const bool turns = has_orientations(waypoints.file);
  task.mask = turns ? TaskMask::kPose : TaskMask::kPosition;
  auto spline = std::make_shared<const PositionSpline>(load_waypoints(waypoints.file, true));
  // Without orientations any one will do: it is not tracked.
  task.orientation = turns ? load_orientations(waypoints.file) : ToolOrientation();
  task.start_time = spline->begin();
  task.duration = spline->end() - spline->begin();
  task.path.spline = std::move(spline);
  return task;
}

void require_passable(const PathWalk& walk, const Scenario& task) {
  const std::string problem = trouble(walk, task).problem;
  if (problem.empty()) return;
  // The advice of a WalkTrouble is for scenarios.
  throw InputError(InputPlace{task.source}, problem + "; move the waypoints, or give a joint motion");
}

ToolPath tool_path(const ToolWaypoints& waypoints, double period) {
  constexpr double kNoCentering = 0.0;
  const Scenario task = task_along(waypoints);
  ToolPath path;
  path.turns = tracks_orientation(task.mask);
  path.position = best_start_of_task(task);
  require_passable(walk_path(task, path.position, kNoCentering), task);
  path.waypoints = later_waypoints(waypoints, path.turns);
  path.start = resting_joints(*waypoints.robot, path.position, period);
  path.duration = kRestBeforePath + task.duration / waypoints.speed + kRestAfterPath;
  return path;
}

}  // namespace armtune::internal
