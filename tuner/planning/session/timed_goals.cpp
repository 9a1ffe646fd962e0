#include "tuner/planning/session/timed_goals.hpp"

#include <fmt/format.h>

#include <utility>

#include "armtune/error.hpp"
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

}  // namespace

JointSpline time_goals(const JointGoals& goals) {
  PlanTask task = move_of(goals);
  const JointVector zero = task.start.velocity;
  std::vector<double> time = {0.0};
  std::vector<MotionPoint<JointVector>> knots = {{goals.positions.front(), zero, zero}};
  for (std::size_t k = 1; k < goals.positions.size(); ++k) {
    task.start.position = knots.back().position;
    task.goal = goals.positions[k];
    if (!(task.goal - task.start.position).isZero(0.0)) {
      const PlannedTrajectory planned = solve_plan(plan_problem(task));
      if (planned.result.status != PlanStatus::kSolved)
        throw InputError(
            InputPlace{goals.file},
            fmt::format("no motion was found from goal {} to goal {} that keeps the limits of the arm and "
                        "its distance from itself and the cell; add a goal between them, or give times",
                        k, k + 1));
      const Trajectory& move = planned.trajectory;
      const double begin = time.back();
      for (Eigen::Index i = 1; i < move.position.cols(); ++i) {
        time.push_back(begin + move.time[static_cast<std::size_t>(i)]);
        knots.push_back({move.position.col(i), move.velocity.col(i), move.acceleration.col(i)});
      }
      knots.back() = {task.goal, zero, zero};  // the solver meets it to its tolerance
    }
    time.push_back(time.back() + kRest);
    knots.push_back({task.goal, zero, zero});
  }
  return {std::move(time), std::move(knots)};
}

}  // namespace armtune::internal
