#include "tuner/planning/session/tool_waypoints.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "armtune/error.hpp"
#include "sim/scenario/start_of_task.hpp"
#include "tuner/controller_study/tool_path.hpp"
#include "tuner/planning/output/ros_trajectory.hpp"
#include "tuner/planning/transcription/trajectory.hpp"

namespace armtune::internal {
namespace {

constexpr double kCentering = 0.2;  // 1/s: motion in the null space towards the middle of the joints' ranges

/// Throws InputError if a joint moves faster than its limit.
void check_velocities(const Trajectory& motion, const ToolWaypoints& waypoints) {
  const RobotModel& robot = *waypoints.robot;
  const Eigen::MatrixXd shares =
      robot.velocity_limits().cwiseInverse().asDiagonal() * motion.velocity.cwiseAbs();
  Eigen::Index joint = 0;
  Eigen::Index point = 0;
  const double most = shares.maxCoeff(&joint, &point);
  if (most <= 1.0) return;
  throw InputError(
      InputPlace{waypoints.file.path},
      fmt::format(
          "at {:.3g} s joint {} would need {:.3g} times its velocity limit; leave more time between the "
          "waypoints, or slow the motion down with --speed {:.2g}",
          motion.time[static_cast<std::size_t>(point)], robot.joints[static_cast<std::size_t>(joint)].name,
          most, std::floor(90.0 * waypoints.speed / most) / 100.0));
}

/// Converts the motion of a walk into one that begins at 0 s, at rest at both ends, at a factor on the speed.
Trajectory trajectory_of(const JointWalk& walked, double speed) {
  Trajectory motion;
  const auto count = static_cast<Eigen::Index>(walked.time.size());
  const Eigen::Index joints = walked.positions.front().position.size();
  motion.position.resize(joints, count);
  motion.velocity.setZero(joints, count);
  motion.acceleration.setZero(joints, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    motion.time.push_back((walked.time[at] - walked.time.front()) / speed);
    motion.position.col(k) = walked.positions[at].position;
  }
  motion.durations = {motion.time.back()};
  make_continuous(motion);
  return motion;
}

}  // namespace

TimedGoals motion_along(const ToolWaypoints& waypoints) {
  const Scenario task = task_along(waypoints);
  const JointWalk walked = joints_along_path(task, best_start_of_task(task), kCentering);
  require_passable(walked.walk, task);
  const Trajectory motion = trajectory_of(walked, waypoints.speed);
  check_velocities(motion, waypoints);
  std::vector<MotionPoint<JointVector>> knots;
  for (Eigen::Index k = 0; k < motion.position.cols(); ++k)
    knots.push_back({motion.position.col(k), motion.velocity.col(k), motion.acceleration.col(k)});
  const RosVersion version = waypoints.ros2 ? RosVersion::kRos2 : RosVersion::kRos1;
  return {
      JointSpline(motion.time, knots),
      ros_trajectory(
          *waypoints.robot, motion, version,
          {"trajectory_msgs/JointTrajectory by armtune, along the tool's waypoints of " + waypoints.file.path,
           "The robot must be at the first point when the motion begins. Run the motion slowly "
           "first."})};
}

}  // namespace armtune::internal
