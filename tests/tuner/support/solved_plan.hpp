#pragma once
// Plans that are solved once.

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tuner/planning/output/limit_use.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune::internal::test {

struct Solved {
  PlanTask task;
  PlanProblem problem;
  PlannedTrajectory planned;
  std::vector<LimitUse> uses;

  Solved(PlanTask given, int knots) : task(std::move(given)) {
    task.knots = knots;
    problem = plan_problem(task);
    planned = solve_plan(problem);
    EXPECT_EQ(planned.result.status, PlanStatus::kSolved) << task.name;
    uses = limit_uses(task, problem, planned);
  }
  const Trajectory& motion() const { return planned.trajectory; }
  const RobotModel& robot() const { return *problem.robot; }
};

inline const Solved& a_switch() {
  static const Solved solved(load_plan_task("ur10_switch"), 60);
  return solved;
}

inline const Solved& a_limited_move() {
  static const Solved solved = [] {
    PlanTask task = load_plan_task("ur10_move");
    task.limits.velocity = 0.5;
    task.limits.effort = 0.75;
    task.limits.acceleration = JointVector::Constant(6, 8.0);
    task.limits.jerk = JointVector::Constant(6, 100.0);
    return Solved(task, 40);
  }();
  return solved;
}

inline const Solved& a_return() {
  static const Solved solved(load_plan_task("ur10_return"), 60);
  return solved;
}

}  // namespace armtune::internal::test
