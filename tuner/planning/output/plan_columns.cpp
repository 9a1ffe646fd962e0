#include "tuner/planning/output/plan_columns.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

namespace armtune::internal {
namespace {

constexpr const char* kAxes[] = {"x", "y", "z"};

class Columns {
 public:
  explicit Columns(const PlanTask& task) : task_(task) {}

  void add(const std::string& name, const std::string& unit, const std::string& meaning,
           std::function<double(const PlanSample&)> value) {
    columns_.push_back({name, unit, meaning, std::move(value)});
  }

  void add_vector(const std::string& name, const std::string& meaning, Vec3 (*value)(const PlanSample&)) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      add(name + "/" + kAxes[axis], "m", fmt::format("{}, {}", meaning, kAxes[axis]),
          [axis, value](const PlanSample& at) { return value(at)[axis]; });
    }
  }

  void add_tool() {
    add_vector("tool/position", "tool position in the base frame",
               [](const PlanSample& at) { return at.poses.p_0T; });
  }

  void add_orientation() {
    const char* parts[] = {"x", "y", "z"};
    add("tool/orientation/w", "1", "tool orientation in the base frame, quaternion w",
        [](const PlanSample& at) { return Eigen::Quaterniond(at.poses.R_0T).w(); });
    for (Eigen::Index i = 0; i < 3; ++i) {
      add(fmt::format("tool/orientation/{}", parts[i]), "1",
          fmt::format("tool orientation in the base frame, quaternion {}", parts[i]),
          [i](const PlanSample& at) { return Eigen::Quaterniond(at.poses.R_0T).vec()[i]; });
    }
  }

  void add_gaze() {
    add("gaze/angle", "rad", "angle between the tool's z axis and the line to the gaze target",
        [](const PlanSample& at) { return at.gaze; });
  }

  void add_joints(const RobotModel& robot, bool with_jerk) {
    for (int i = 0; i < robot.n(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const bool turns = robot.chain.motion[k] == JointMotion::kRevolute;
      const std::string length = turns ? "rad" : "m";
      const std::string tree = "joint/" + robot.joints[k].name + "/";
      const JointLimits limits = robot.joints[k].limits;
      add(tree + "position", length, "joint position", [i](const PlanSample& at) { return at.q[i]; });
      add(tree + "velocity", length + "/s", "joint velocity", [i](const PlanSample& at) { return at.qd[i]; });
      add(tree + "acceleration", length + "/s^2", "joint acceleration, linear between knots",
          [i](const PlanSample& at) { return at.qdd[i]; });
      if (with_jerk) {
        add(tree + "jerk", length + "/s^3", "joint jerk, constant between knots",
            [i](const PlanSample& at) { return at.jerk[i]; });
      }
      add(tree + "torque", turns ? "N m" : "N", "joint torque from the inverse dynamics",
          [i](const PlanSample& at) { return at.tau[i]; });
      add(tree + "velocity_ratio", "1", of_robot("velocity", task_.limits.velocity),
          [i, limits](const PlanSample& at) { return std::abs(at.qd[i]) / limits.velocity; });
      add(tree + "torque_ratio", "1", of_robot("torque", task_.limits.effort),
          [i, limits](const PlanSample& at) { return std::abs(at.tau[i]) / limits.effort; });
    }
  }

  std::vector<PlanColumn> take() { return std::move(columns_); }

 private:
  static std::string of_robot(const char* what, double share) {
    return fmt::format("|{}| divided by the robot's limit; this task allows {:.4g}", what, share);
  }

  const PlanTask& task_;
  std::vector<PlanColumn> columns_;
};

}  // namespace

std::vector<PlanColumn> trajectory_columns(const PlanTask& task, const RobotModel& robot) {
  Columns columns(task);
  columns.add("time", "s", "scenario time", [](const PlanSample& at) { return at.time; });
  columns.add_tool();
  columns.add_orientation();
  columns.add_gaze();
  columns.add_joints(robot, false);
  if (task.kind == PlanKind::kFastest) {
    columns.add("path/coordinate", "s",
                "path coordinate: time that the scenario's desired motion takes from the start of the task "
                "to this point",
                [](const PlanSample& at) { return at.s; });
  }
  return columns.take();
}

std::vector<PlanColumn> motion_columns(const PlanTask& task, const RobotModel& robot) {
  const ToolDemands demands = tool_demands(task);
  Columns columns(task);
  columns.add("time", "s", "scenario time", [](const PlanSample& at) { return at.time; });
  columns.add_tool();
  if (demands.path) {
    columns.add_vector("desired/position", "tool position that the path prescribes, base frame",
                       [](const PlanSample& at) { return at.desired; });
    columns.add_vector("error/position", "tool position minus desired position, base frame",
                       [](const PlanSample& at) { return Vec3(at.poses.p_0T - at.desired); });
  }
  if (demands.gaze) {
    columns.add_vector("target/position", "position of the gaze target, base frame",
                       [](const PlanSample& at) { return at.target; });
    columns.add_gaze();
  }
  if (task.clearance > 0.0 && task.scenario.clearance) {
    const auto add = [&](const char* column, Clearance kind, const char* meaning) {
      if (!task.scenario.clearance->has(kind)) return;
      columns.add(column, "m", meaning,
                  [kind](const PlanSample& at) { return least_of(kind, at.cell).distance; });
    };
    add("clearance/self", Clearance::kSelf, "least distance between two links that are not neighbours");
    add("clearance/cell", Clearance::kCell, "least distance between a link and a part of the cell");
    add("clearance/floor", Clearance::kFloor, "least height of a link above the floor");
  }
  if (task.clearance > 0.0 && !task.scenario.obstacles.empty()) {
    columns.add("obstacle/distance", "m",
                "least distance from an obstacle's surface to the tool or to a joint origin that can move",
                [](const PlanSample& at) { return at.clearance; });
  }
  columns.add_joints(robot, task.limits.jerk.size() > 0);
  return columns.take();
}

std::vector<Column> described(const std::vector<PlanColumn>& columns) {
  std::vector<Column> found;
  found.reserve(columns.size());
  for (const PlanColumn& column : columns) found.push_back({column.name, column.unit, column.meaning, {}});
  return found;
}

}  // namespace armtune::internal
