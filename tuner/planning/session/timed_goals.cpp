#include "tuner/planning/session/timed_goals.hpp"

#include <fmt/format.h>

#include <utility>

#include "armtune/error.hpp"
#include "tuner/planning/output/contact_note.hpp"
#include "tuner/planning/output/ros_trajectory.hpp"
#include "tuner/planning/tasks/given_states.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"
#include "tuner/planning/transcription/arm_terms.hpp"

namespace armtune::internal {
namespace {

constexpr double kShare = 0.8;      // share of the robot's limits that is used; studies allow 0.9
constexpr double kSpeedUp = 0.5;    // s from rest to the velocity limit, at least
constexpr double kForceUp = 0.1;    // s from no acceleration to the acceleration limit
constexpr double kRest = 0.5;       // s at every goal
constexpr double kFromCell = 0.02;  // m, distance to keep from the cell
constexpr int kKnots = 60;          // intervals of each move

/// Returns the task of a move, without start position and goal.
PlanTask move_of(const JointGoals& goals) {
  const RobotModel& robot = *goals.robot;
  PlanTask task;
  task.name = task.source = goals.file;
  task.kind = PlanKind::kMove;
  task.scenario.name = robot.name;
  task.scenario.robot = goals.robot;
  task.scenario.clearance = goals.clearance;
  if (goals.clearance && !goals.clearance->pairs().empty()) task.clearance = kFromCell;
  task.limits.velocity = task.limits.effort = kShare;
  task.limits.acceleration =
      kShare * robot.acceleration_limits().cwiseMin(robot.velocity_limits() / kSpeedUp);
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
  /// Adds a knot at rest at q [rad, m], at a time [s].
  void rest(double time, const JointVector& q) {
    const JointVector zero = JointVector::Zero(q.size());
    time_.push_back(time);
    knots_.push_back({q, zero, zero});
  }
  /// Adds a move that begins where this motion ends. It ends at rest exactly at the goal.
  void add(const Trajectory& move, const JointVector& goal) {
    const double begin = end();
    for (Eigen::Index k = 1; k + 1 < move.position.cols(); ++k) {
      time_.push_back(begin + move.time[static_cast<std::size_t>(k)]);
      knots_.push_back({move.position.col(k), move.velocity.col(k), move.acceleration.col(k)});
    }
    rest(begin + move.time.back(), goal);
  }
  /// Multiplies the speed of the whole motion by a factor.
  void change_speed(double factor) {
    for (double& time : time_) time /= factor;
    for (MotionPoint<JointVector>& knot : knots_) {
      knot.velocity *= factor;
      knot.acceleration *= factor * factor;
    }
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

void refuse_moving_parts(const JointGoals& goals) {
  if (!goals.clearance) return;
  for (const CellPart& part : goals.clearance->cell().parts) {
    if (!part.path.rests())
      throw InputError(
          InputPlace{goals.file},
          fmt::format("the joint goals have no times, but part '{}' of the cell moves, so its position at "
                      "each goal is not known; give the times of the goals",
                      part.name));
  }
}

/// Throws InputError if the arm violates a limit at rest at a goal.
void check_goals(const JointGoals& goals, const PlanTask& task) {
  std::vector<std::pair<KnotTerm, const char*>> terms = {
      {torque_limits(*goals.robot, {0, 0}, kShare), "choose a position that needs less torque"}};
  if (task.clearance > 0.0) {
    for (KnotTerm& term : clear_of_cell(goals.clearance, {0, 0}, task.clearance))
      terms.emplace_back(std::move(term), "choose a position farther away");
  }
  for (std::size_t k = 0; k < goals.positions.size(); ++k) {
    const Knot state = at_rest(*goals.robot, goals.positions[k], 0.0);
    for (const auto& [term, advice] : terms) {
      if (const auto broken = broken_term(term, state))
        throw InputError(InputPlace{goals.file},
                         fmt::format("goal {}: {}, but the limit of a planned motion is {:.4g}; {}", k + 1,
                                     broken->value, broken->limit, advice));
    }
  }
}

}  // namespace

std::optional<TimedGoals> time_goals(const JointGoals& goals, const std::atomic<bool>& stop,
                                     const std::function<void(std::size_t, std::size_t)>& progress) {
  refuse_moving_parts(goals);
  PlanTask task = move_of(goals);
  check_goals(goals, task);
  Motion motion(goals.positions.front());
  const std::size_t moves = goals.positions.size() - 1;
  for (std::size_t k = 1; k <= moves; ++k) {
    if (progress) progress(k - 1, moves);
    task.start.position = motion.position();
    task.goal = goals.positions[k];
    if (!(task.goal - task.start.position).isZero(0.0)) {
      const PlannedTrajectory planned =
          solve_plan(plan_problem(task), {}, [&stop](const SequentialQuadraticProgress&) { return !stop; });
      if (stop) return std::nullopt;
      if (planned.result.status != PlanStatus::kSolved)
        throw InputError(
            InputPlace{goals.file},
            fmt::format(
                "no motion was found from goal {} to goal {} that respects the limits of the arm and "
                "its distances from the cell and between links; add a goal between them, or give times",
                k, k + 1));
      motion.add(planned.trajectory, task.goal);
    }
    motion.rest(motion.end() + kRest, task.goal);
  }
  if (stop) return std::nullopt;
  if (goals.speed != 1.0) motion.change_speed(goals.speed);
  return TimedGoals{
      motion.spline(),
      ros_trajectory(*goals.robot, motion.trajectory(), goals.ros2 ? RosVersion::kRos2 : RosVersion::kRos1,
                     {"trajectory_msgs/JointTrajectory by armtune, through the joint goals of " + goals.file,
                      contact_note(task) + " The robot must be at the first point when the motion "
                                           "begins. Run the motion slowly first."})};
}

}  // namespace armtune::internal
