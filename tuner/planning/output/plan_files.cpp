#include "tuner/planning/output/plan_files.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/robot/dynamics.hpp"
#include "core/trajectory/gaze.hpp"
#include "sim/csv/cell.hpp"

namespace armtune {
namespace {

std::string list(const Eigen::MatrixXd& values, Eigen::Index n, Eigen::Index column) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < n; ++i) text += (i == 0 ? "" : ", ") + cell(values(i, column));
  return text + "]";
}

}  // namespace

std::vector<Column> trajectory_columns(const RobotModel& robot, bool path_coordinate) {
  std::vector<Column> columns;
  const auto add = [&](const std::string& name, const std::string& unit, const std::string& meaning) {
    columns.push_back({name, unit, meaning, {}});
  };
  add("time", "s", "time of the scenario");
  for (const char* axis : {"x", "y", "z"})
    add(std::string("tool/position/") + axis, "m", std::string("tool in the base frame, ") + axis);
  for (const char* part : {"w", "x", "y", "z"})
    add(std::string("tool/orientation/") + part, "1",
        std::string("tool in the base frame, quaternion ") + part);
  add("gaze/angle", "rad", "angle between tool z and the line to the target");
  for (int i = 0; i < robot.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool turns = robot.chain.motion[k] == JointMotion::kRevolute;
    const std::string length = turns ? "rad" : "m";
    const std::string tree = "joint/" + robot.joints[k].name + "/";
    add(tree + "position", length, "joint position");
    add(tree + "velocity", length + "/s", "joint velocity");
    add(tree + "acceleration", length + "/s^2", "joint acceleration, linear between rows");
    add(tree + "torque", turns ? "N m" : "N", "torque of the inverse dynamics");
    add(tree + "velocity_ratio", "1", "|velocity| over its limit");
    add(tree + "torque_ratio", "1", "|torque| over its limit");
  }
  if (path_coordinate) add("path/coordinate", "s", "how far along the path, in the path's own time");
  return columns;
}

std::string trajectory_csv(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory) {
  const RobotModel& robot = *problem.robot;
  const int n = robot.n();
  const bool path_coordinate = trajectory.position.rows() > n;
  std::string text;
  for (const Column& column : trajectory_columns(robot, path_coordinate))
    text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  const MovingPoint target = active_target(task.scenario);
  Poses poses;
  JointVector tau;
  for (std::size_t k = 0; k < trajectory.time.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const JointVector q = trajectory.position.col(column).head(n);
    const JointVector qd = trajectory.velocity.col(column).head(n);
    const JointVector qdd = trajectory.acceleration.col(column).head(n);
    forward_kinematics(robot.chain, q, poses);
    inverse_dynamics(robot.chain, poses, qd, qdd, tau);
    text += cell(trajectory.time[k]);
    for (int i = 0; i < 3; ++i) text += "," + cell(poses.p_0T[i]);
    const Eigen::Quaterniond orientation(poses.R_0T);
    for (const double part : {orientation.w(), orientation.x(), orientation.y(), orientation.z()})
      text += "," + cell(part);
    text += "," + cell(gaze_angle(poses.R_0T, poses.p_0T, target(trajectory.time[k]).position));
    for (int i = 0; i < n; ++i) {
      const JointLimits& limits = robot.joints[static_cast<std::size_t>(i)].limits;
      for (const double value :
           {q[i], qd[i], qdd[i], tau[i], std::abs(qd[i]) / limits.velocity, std::abs(tau[i]) / limits.effort})
        text += "," + cell(value);
    }
    if (path_coordinate) text += "," + cell(trajectory.position(n, column));
    text += '\n';
  }
  return text;
}

std::string ros_trajectory(const RobotModel& robot, const Trajectory& trajectory, RosVersion version,
                           const std::vector<std::string>& header) {
  std::string text;
  for (const std::string& line : header) text += "# " + line + "\n";
  text += "joint_names:\n";
  for (const std::string& joint : joint_names(robot)) text += "  - " + joint + "\n";
  text += "points:\n";
  const bool two = version == RosVersion::kRos2;
  for (std::size_t k = 0; k < trajectory.time.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const long long nanoseconds = std::llround((trajectory.time[k] - trajectory.time.front()) * 1e9);
    text += "  - positions: " + list(trajectory.position, robot.n(), column) + "\n";
    text += "    velocities: " + list(trajectory.velocity, robot.n(), column) + "\n";
    text += "    accelerations: " + list(trajectory.acceleration, robot.n(), column) + "\n";
    text += fmt::format("    time_from_start: {{{}: {}, {}: {}}}\n", two ? "sec" : "secs",
                        nanoseconds / 1'000'000'000, two ? "nanosec" : "nsecs", nanoseconds % 1'000'000'000);
  }
  return text;
}

}  // namespace armtune
