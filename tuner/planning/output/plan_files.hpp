#pragma once
// A planned motion as files: CSV, and a trajectory that ROS controllers take.

#include <string>
#include <vector>

#include "sim/rollout/columns.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune {

/// Names, units and meanings of the columns of trajectory.csv.
std::vector<Column> trajectory_columns(const RobotModel& robot, bool path_coordinate);

/// Text of trajectory.csv: a row a knot, every limit's ratio beside its value.
std::string trajectory_csv(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory);

enum class RosVersion { kRos1, kRos2 };

/// trajectory_msgs/JointTrajectory as YAML, for `ros2 topic pub` or `rostopic pub`: times from its own start.
std::string ros_trajectory(const RobotModel& robot, const Trajectory& trajectory, RosVersion version,
                           const std::vector<std::string>& header);

}  // namespace armtune
