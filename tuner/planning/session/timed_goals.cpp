#include "tuner/planning/session/timed_goals.hpp"

#include <fmt/format.h>

#include <utility>

#include "armtune/error.hpp"
#include "tuner/planning/output/ros_trajectory.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune::internal {
namespace {

constexpr double kShare = 0.8;      // of velocity and effort limits
constexpr double kSpeedUp = 0.5;    // s from rest to the permitted velocity
constexpr double kForceUp = 0.1;    // s from no acceleration to the permitted one
constexpr double kRest = 0.5;       // s at every goal
constexpr double kFromCell = 0.02;  // m
constexpr int kKnots = 60;          // intervals of each move

/// The task of a move, without start and goal.
PlanTask move_of(const JointGoals& goals) {
  const RobotModel& robot = *goals.robot;
  PlanTask task;
  task.name = task.source = goals.file;
  task.kind = PlanKind::kMove;
  task.scenario.name = goals.file;
  task.scenario.robot = goals.robot;
  task.scenario.clearance = goals.clearance;
  if (goals.clearance && !goals.clearance->pairs().empty()) task.clearance = kFromCell;
  task.limits.velocity = task.limits.effort = kShare;
  task.limits.acceleration =
      robot.acceleration_limits().cwiseMin(kShare / kSpeedUp * robot.velocity_limits());
  task.limits.jerk = task.limits.acceleration / kForceUp;
  task.knots = kKnots;
  task.start.velocity = task.start.acceleration = JointVector::Zero(robot.n());
  return task;
}

/// A motion that grows knot by knot.
class Motion {
 public:
  explicit Motion(const JointVector& start) { rest(0.0, start); }

  double end() const { return time_.back(); }
  const JointVector& position() const { return knots_.back().position; }
  /// At rest at q at a time [s].
  void rest(double time, const JointVector& q) {
    const JointVector zero = JointVector::Zero(q.size());
    time_.push_back(time);
    knots_.push_back({q, zero, zero});
  }
  /// A move that begins where this motion ends, up to its goal exactly.
  void add(const Trajectory& move, const JointVector& goal) {
    const double begin = end();
    for (Eigen::Index k = 1; k + 1 < move.position.cols(); ++k) {
      time_.push_back(begin + move.time[static_cast<std::size_t>(k)]);
      knots_.push_back({move.position.col(k), move.velocity.col(k), move.acceleration.col(k)});
    }
    rest(begin + move.time.back(), goal);
  }
  JointSpline spline() const { return {time_, knots_}; }
  Trajectory trajectory() const {
    Trajectory motion;
    motion.time = time_;
    const auto count = static_cast<Eigen::Index>(knots_.size());
    for (Eigen::MatrixXd* values : {&motion.position, &motion.velocity, &motion.acceleration})
      values->resize(position().size(), count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const MotionPoint<JointVector>& knot = knots_[static_cast<std::size_t>(k)];
      motion.position.col(k) = knot.position;
      motion.velocity.col(k) = knot.velocity;
      motion.acceleration.col(k) = knot.acceleration;
    }
    return motion;
  }

 private:
  std::vector<double> time_;
  std::vector<MotionPoint<JointVector>> knots_;
};

}  // namespace

TimedGoals time_goals(const JointGoals& goals) {
  PlanTask task = move_of(goals);
  Motion motion(goals.positions.front());
  for (std::size_t k = 1; k < goals.positions.size(); ++k) {
    task.start.position = motion.position();
    task.goal = goals.positions[k];
    if (!(task.goal - task.start.position).isZero(0.0)) {
      const PlannedTrajectory planned = solve_plan(plan_problem(task));
      if (planned.result.status != PlanStatus::kSolved)
        throw InputError(
            InputPlace{goals.file},
            fmt::format("no motion was found from goal {} to goal {} that keeps the limits of the arm and "
                        "its distance from itself and the cell; add a goal between them, or give times",
                        k, k + 1));
      motion.add(planned.trajectory, task.goal);
    }
    motion.rest(motion.end() + kRest, task.goal);
  }
  return {
      motion.spline(),
      ros_trajectory(*goals.robot, motion.trajectory(), goals.ros2 ? RosVersion::kRos2 : RosVersion::kRos1,
                     {"trajectory_msgs/JointTrajectory by armtune, through the joint goals of " + goals.file,
                      "Run it slowly first. docs/joint_trajectory_controller.md states its limits."})};
}

}  // namespace armtune::internal
