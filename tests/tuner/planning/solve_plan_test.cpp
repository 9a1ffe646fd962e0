#include "tuner/planning/tasks/solve_plan.hpp"

#include <gtest/gtest.h>

#include "tuner/planning/output/binding_limits.hpp"

namespace armtune {
namespace {

PlanTask slow_wrists(double acceleration) {
  PlanTask task = load_plan_task("ur10_switch");
  task.limits.acceleration = JointVector::Constant(6, acceleration);
  task.path_tolerance = 1e-4;
  return task;
}

TEST(SolvePlan, ASwitchUnderTightLimitsIsSolvedInFewSteps) {
  double before = 0.0;
  for (const double acceleration : {4.0, 2.0, 1.0}) {
    const PlannedTrajectory planned = solve_plan(plan_problem(slow_wrists(acceleration)));
    ASSERT_EQ(planned.result.status, PlanStatus::kSolved) << acceleration;
    EXPECT_LT(planned.interior_iterations, 1000) << acceleration;
    // Less acceleration never takes less time.
    EXPECT_GT(planned.trajectory.durations.front(), before) << acceleration;
    before = planned.trajectory.durations.front();
  }
}

TEST(SolvePlan, TheMotionOfAGivenDurationIsTheSameByWayOfTheLeastTimeAndFromAfar) {
  PlanTask task = load_plan_task("ur10_switch");
  task.knots = 60;
  const double least = solve_plan(plan_problem(task)).trajectory.durations.front();
  for (const double factor : {1.2, 2.0}) {
    task.duration = factor * least;
    const PlanProblem problem = plan_problem(task);
    const PlannedTrajectory planned = solve_plan(problem);
    const PlannedTrajectory direct = solve_refining(problem.task, problem.grid, problem.guess, {}, {});
    ASSERT_EQ(planned.result.status, PlanStatus::kSolved) << factor;
    ASSERT_EQ(direct.result.status, PlanStatus::kSolved) << factor;
    EXPECT_NEAR(planned.objective(), direct.objective(), 1e-4 * direct.objective()) << factor;
  }
}

TEST(SolvePlan, NearTheLeastTimeItIsSolvedInFewSteps) {
  PlanTask task = load_plan_task("ur10_switch");
  const double least = solve_plan(plan_problem(task)).trajectory.durations.front();
  for (const double factor : {1.0001, 1.003, 1.03}) {
    task.duration = factor * least;
    const PlannedTrajectory planned = solve_plan(plan_problem(task));
    ASSERT_EQ(planned.result.status, PlanStatus::kSolved) << factor;
    EXPECT_EQ(planned.trajectory.durations.front(), task.duration) << factor;
    EXPECT_LE(planned.result.last.violation, 1e-8);
    EXPECT_LT(planned.interior_iterations, 3000) << factor;
  }
}

TEST(SolvePlan, WhatIsTooShortIsComparedWithTheLeastTimeWhoseLimitsAreNamed) {
  PlanTask task = load_plan_task("ur10_switch");
  const double least = solve_plan(plan_problem(task)).trajectory.durations.front();
  for (const double factor : {0.5, 0.999}) {
    task.duration = factor * least;
    const PlannedTrajectory planned = solve_plan(plan_problem(task));
    EXPECT_EQ(planned.result.status, PlanStatus::kInfeasible);
    EXPECT_TRUE(planned.too_short);
    EXPECT_EQ(planned.trajectory.durations.front(), least);
    EXPECT_FALSE(binding_limits(planned).empty());
  }
}

TEST(SolvePlan, WhatNoDurationIsEnoughForIsNotCalledTooShort) {
  PlanTask task = load_plan_task("ur10_return");
  task.knots = 30;
  task.duration = 1.0;
  task.limits.effort = 0.1;  // less than it takes to hold the arm on its path
  const PlannedTrajectory planned = solve_plan(plan_problem(task));
  EXPECT_EQ(planned.result.status, PlanStatus::kInfeasible);
  EXPECT_FALSE(planned.too_short);
}

}  // namespace
}  // namespace armtune
