#include "tuner/planning/tasks/solve_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tuner/planning/output/binding_limits.hpp"

namespace armtune::internal {
namespace solve_plan_test {

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

TEST(SolvePlan, AlongAPathMoreTimeIsSmootherAndFoundInFewSteps) {
  PlanTask task = load_plan_task("ur10_fastest_circle");
  task.knots = 60;
  const double least = solve_plan(plan_problem(task)).trajectory.durations.front();
  double before = INFINITY;
  for (const double factor : {1.01, 1.3, 3.0, 10.0}) {
    task.duration = factor * least;
    const PlannedTrajectory planned = solve_plan(plan_problem(task));
    ASSERT_EQ(planned.result.status, PlanStatus::kSolved) << factor;
    EXPECT_LT(planned.objective(), before) << factor;
    EXPECT_LT(planned.interior_iterations, 3000) << factor;
    // What is weighed is large beside the tolerance, or the least of it would be none.
    EXPECT_GT(planned.weight * planned.objective(), 1e-3) << factor;
    before = planned.objective();
  }
}

TEST(SolvePlan, WhoMovesTooFastToStopAtTheGoalComesBackToIt) {
  for (const double speed : {1.0, 2.0, 3.0}) {
    constexpr double kAcceleration = 3.0;
    constexpr double kAhead = 0.1;  // rad
    PlanTask task = load_plan_task("ur10_move");
    task.limits.acceleration = JointVector::Constant(6, kAcceleration);
    task.start.position = task.goal = task.scenario.start_position;
    task.start.velocity = JointVector::Zero(6);
    task.start.velocity[5] = speed;
    task.goal[5] += kAhead;
    const double beyond = speed * speed / (2.0 * kAcceleration) - kAhead;
    const double exact = speed / kAcceleration + 2.0 * std::sqrt(beyond / kAcceleration);
    const PlannedTrajectory planned = solve_plan(plan_problem(task));
    ASSERT_EQ(planned.result.status, PlanStatus::kSolved) << speed;
    const double found = planned.trajectory.durations.front();
    EXPECT_GE(found, exact * (1.0 - 1e-6)) << speed;
    EXPECT_LE(found, exact * 1.01) << speed;  // ends without acceleration, on a grid
  }
}

TEST(SolvePlan, AStopIsNotPassedBetweenTheKnotsEither) {
  PlanTask task = load_plan_task("ur10_move");
  task.knots = 14;
  task.limits.acceleration = JointVector::Constant(6, 2.0);
  const double stop = task.scenario.robot->joints[5].limits.upper;
  task.start.position = task.goal = task.scenario.start_position;
  task.start.velocity = JointVector::Zero(6);
  task.start.velocity[5] = 1.0;  // takes 0.25 rad to stop
  task.goal[5] = stop - 1.0;
  task.start.position[5] = stop - 0.27;
  const PlannedTrajectory planned = solve_plan(plan_problem(task));
  ASSERT_EQ(planned.result.status, PlanStatus::kSolved);
  const Trajectory& motion = planned.trajectory;
  double largest = -INFINITY;
  for (int i = 0; i <= 2000; ++i) {
    const double t = motion.time.front() + motion.durations.front() * i / 2000;
    largest = std::max(largest, point_at(motion, t).position[5]);
  }
  EXPECT_GT(largest, stop - 0.02) << "or this test says nothing";
  EXPECT_LE(largest, stop * (1.0 + 1e-8));
  task.start.position[5] = stop - 0.2;
  EXPECT_EQ(solve_plan(plan_problem(task)).result.status, PlanStatus::kInfeasible);
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

}  // namespace solve_plan_test
}  // namespace armtune::internal
