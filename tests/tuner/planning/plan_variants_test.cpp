// Plans beside the bundled ones: other durations, thresholds, starts and arms.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/trajectory/quintic.hpp"
#include "sim/rollout/recorder.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/planning/output/binding_limits.hpp"
#include "tuner/planning/output/worst_violation.hpp"
#include "tuner/planning/tasks/controller_motion.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune::internal {
namespace plan_variants_test {

PlannedTrajectory solved(const PlanProblem& problem, const PlanObserver& observer = {}) {
  return solve_plan(problem, {}, observer);
}

/// Of a given duration, without a plan of the least time first.
PlannedTrajectory from_afar(const PlanProblem& problem, const PlanObserver& observer = {}) {
  return solve_refining(problem.task, problem.grid, problem.guess, {}, observer);
}

double least_time(const PlanTask& task) {
  const PlannedTrajectory planned = solved(plan_problem(task));
  EXPECT_EQ(planned.result.status, PlanStatus::kSolved) << sentence(worst_violation(planned));
  return planned.trajectory.durations.front();
}

TEST(PlanVariants, WithTimeToSpareAMoveIsTheSmoothestOfAll) {
  PlanTask task = load_plan_task("ur10_move");
  task.duration = 5.0;  // no limit is near
  const PlanProblem problem = plan_problem(task);
  const PlannedTrajectory planned = solved(problem);
  ASSERT_EQ(planned.result.status, PlanStatus::kSolved);
  // Of all motions between two states at rest the quintic has the least jerk; on 200 intervals nearly so.
  const JointVector start = planned.trajectory.position.col(0);
  for (const double part : {0.1, 0.3, 0.5, 0.8}) {
    const double s = rest_to_rest(0.0, 1.0, 5.0).at(5.0 * part).position;
    const TrajectoryPoint point = point_at(planned.trajectory, task.at + 5.0 * part);
    const JointVector expected = start + s * (task.goal - start);
    EXPECT_LE((point.position - expected).lpNorm<Eigen::Infinity>(), 2e-5) << part;
  }
}

TEST(PlanVariants, WhatTheLeastTimeIsEnoughForIsFeasibleAndNothingShorter) {
  PlanTask task = load_plan_task("ur10_move");
  const double least = least_time(task);
  double least_effort = INFINITY;
  for (const double factor : {0.9, 0.99, 1.001, 1.02, 1.2}) {
    task.duration = factor * least;
    const PlannedTrajectory planned = solved(plan_problem(task));
    EXPECT_EQ(planned.result.status, factor < 1.0 ? PlanStatus::kInfeasible : PlanStatus::kSolved) << factor;
    // Less time is never smoother.
    if (factor > 1.0) {
      EXPECT_LT(planned.objective(), least_effort) << factor;
      least_effort = planned.objective();
    }
    EXPECT_EQ(planned.too_short, factor < 1.0);
    if (factor < 1.0) {
      EXPECT_NEAR(planned.trajectory.durations.front(), least, 1e-6 * least);
      // What cannot be is asked of the goal; the start is as it is.
      const PlannedTrajectory missed = from_afar(plan_problem(task));
      EXPECT_EQ(missed.result.status, PlanStatus::kInfeasible);
      EXPECT_EQ(worst_violation(missed).meaning.limit, "goal");
    }
  }
}

TEST(PlanVariants, ACoarseGridsWantOfKnotsIsNoVerdict) {
  // One joint under an acceleration limit a, which changes in straight lines from knot to knot: from rest to
  // rest over N intervals takes 2 sqrt(way / a / (1 - 2 / N)) at least.
  PlanTask task = load_plan_task("ur10_move");
  task.limits.acceleration = JointVector::Constant(6, 0.3);
  task.start.position = task.scenario.start_position;
  task.start.position[0] = -6.0;
  task.start.velocity = task.start.acceleration = JointVector::Zero(6);
  task.goal = task.start.position;
  task.goal[0] = 6.0;
  for (const int knots : {200, 640}) {
    const double least = 2.0 * std::sqrt(12.0 / 0.3 / (1.0 - 2.0 / knots));
    task.knots = knots;
    task.duration = 1.001 * least;
    EXPECT_EQ(solved(plan_problem(task)).result.status, PlanStatus::kSolved) << knots;
    EXPECT_EQ(from_afar(plan_problem(task)).result.status, PlanStatus::kSolved) << knots;
  }
  task.knots = 200;
  task.duration = 0.999 * 2.0 * std::sqrt(12.0 / 0.3 / (1.0 - 2.0 / task.knots));
  EXPECT_EQ(solved(plan_problem(task)).result.status, PlanStatus::kInfeasible);
  EXPECT_EQ(from_afar(plan_problem(task)).result.status, PlanStatus::kInfeasible);
}

TEST(PlanVariants, WhatIsFarFromFeasibleIsCalledSoBeforeTheStepsRunOut) {
  PlanTask task = load_plan_task("ur10_fastest_circle");
  task.duration = 0.2;
  task.knots = 30;
  int last = 0;
  const PlannedTrajectory planned =
      from_afar(plan_problem(task), [&last](const SequentialQuadraticProgress& at) {
        last = std::max(last, at.iteration);
        return true;
      });
  EXPECT_EQ(planned.result.status, PlanStatus::kInfeasible);
  EXPECT_LT(last, SequentialQuadraticOptions{}.max_iterations - 1);
  const auto limits = binding_limits(planned);
  ASSERT_FALSE(limits.empty());
  for (const BindingLimit& limit : limits)
    EXPECT_GE(std::abs(limit.value), std::abs(limit.bound) * (1.0 - 1e-4));
}

TEST(PlanVariants, UnderJerkLimitsAnArmAtRestHasNoAcceleration) {
  PlanTask around = load_plan_task("ur10_fastest_circle");
  around.knots = 60;
  around.limits.velocity = 0.3;
  PlanTask move = load_plan_task("ur10_move");
  move.start.position = move.scenario.start_position;
  for (PlanTask task : {around, move}) {
    task.limits.acceleration = JointVector::Constant(6, 1.0);
    const double free_ends = least_time(task);
    task.limits.jerk = JointVector::Constant(6, 5.0);
    const PlannedTrajectory planned = solved(plan_problem(task));
    ASSERT_EQ(planned.result.status, PlanStatus::kSolved) << sentence(worst_violation(planned));
    const Trajectory& motion = planned.trajectory;
    EXPECT_LE(motion.acceleration.col(0).head(6).lpNorm<Eigen::Infinity>(), 1e-7) << task.name;
    EXPECT_LE(motion.acceleration.rightCols<1>().head(6).lpNorm<Eigen::Infinity>(), 1e-7) << task.name;
    const double h = motion.time[1] - motion.time[0];
    const Eigen::MatrixXd jerk = (motion.acceleration.rightCols(motion.acceleration.cols() - 1) -
                                  motion.acceleration.leftCols(motion.acceleration.cols() - 1)) /
                                 h;
    EXPECT_LE(jerk.topRows(6).lpNorm<Eigen::Infinity>(), 5.0 * (1.0 + 1e-6)) << task.name;
    EXPECT_GT(motion.durations.front(), free_ends) << task.name;
  }
}

TEST(PlanVariants, SlowLimitsTakeTheTimeTheyTake) {
  PlanTask task = load_plan_task("ur10_move");
  const JointVector way = (task.goal - task.scenario.start_position).cwiseAbs();
  double before = least_time(task);
  for (const double share : {0.1, 0.01}) {
    task.limits.velocity = share;
    const double time = least_time(task);
    // Next to all of it at the limit of the joint that has the longest way; to get there and to stop takes an
    // interval each.
    const double cruise =
        (way.array() / (share * plan_problem(task).robot->velocity_limits().array())).maxCoeff();
    EXPECT_GT(time, cruise);
    EXPECT_LT(time, cruise * (1.0 + 3.0 / task.knots) + 0.1);
    EXPECT_GT(time, before);
    before = time;
  }
}

TEST(PlanVariants, ASmallerThresholdTakesLonger) {
  PlanTask task = load_plan_task("ur10_switch");
  task.knots = 60;
  double before = 0.0;
  for (const double threshold : {0.3, 0.15, 0.02, 0.002}) {
    task.gaze_threshold = threshold;
    const double time = least_time(task);
    EXPECT_GT(time, before) << threshold;
    before = time;
  }
}

TEST(PlanVariants, TheFastestTurnIsFoundInOtherScenariosToo) {
  PlanTask task = load_plan_task("ur10_fastest_circle");
  task.knots = 60;
  task.scenario = load_scenario("fixed_target");
  const double around = least_time(task);
  // No sooner than the slowest joint could go its way at its velocity limit, there and back.
  EXPECT_GT(around, 0.1);
  task.limits.velocity = 0.5;
  EXPECT_GT(least_time(task), around);
}

TEST(PlanVariants, FromARolloutItStartsWhereTheControllerWasAndEndsNoLater) {
  const test::TemporaryFolder folder;
  Scenario scenario = load_scenario("target_switch");
  scenario.duration = 20.0;
  const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
  Recorder recorder(scenario, 5);
  Rollout(scenario, Stepper::kMidpoint).run(gains, [&](const Observation& o) { return recorder(o); });
  recorder.write_csv(folder / "rollout.csv");

  PlanTask task = load_plan_task("ur10_switch");
  task.at = 16.0;
  task.knots = 90;
  task.start = {};
  task.start.rollout = folder / "rollout.csv";
  const PlanProblem problem = plan_problem(task);
  const ControllerMotion controller = controller_motion(task, *problem.robot);
  ASSERT_TRUE(controller.reached.has_value());
  EXPECT_EQ(problem.guess.position.col(0), controller.motion.position.col(0));
  EXPECT_NEAR(problem.guess.durations.front(), std::max(0.2, *controller.reached), 1e-12);
  // The guess is the controller's own motion: the same joint positions at the same time.
  const double later = task.at + 0.5 * problem.guess.durations.front();
  EXPECT_LE((point_at(problem.guess, later).position - point_at(controller.motion, later).position)
                .lpNorm<Eigen::Infinity>(),
            1e-3);
  const PlannedTrajectory planned = solved(problem);
  ASSERT_EQ(planned.result.status, PlanStatus::kSolved);
  EXPECT_LE(planned.trajectory.durations.front(), *controller.reached + 0.01);
  // Given the same state without the rollout the optimum is the same.
  PlanTask cold = task;
  cold.start = {};
  cold.start.position = controller.motion.position.col(0);
  cold.start.velocity = controller.motion.velocity.col(0);
  EXPECT_NEAR(least_time(cold), planned.trajectory.durations.front(), 2e-4);
}

TEST(PlanVariants, StopsBetweenTheStepsOfASubproblem) {
  PlanTask task = load_plan_task("ur10_switch");
  const PlanProblem problem = plan_problem(task);
  int calls = 0;
  int seen = 0;
  const PlannedTrajectory planned = solved(problem, [&](const SequentialQuadraticProgress& at) {
    seen = at.iteration;
    return ++calls < 5;
  });
  EXPECT_EQ(planned.result.status, PlanStatus::kInterrupted);
  EXPECT_EQ(calls, 5);
  EXPECT_EQ(seen, 0) << "the first subproblem takes more steps than that";
}

TEST(PlanVariants, WhatFallsShortIsSaidInItsUnit) {
  PlanTask task = load_plan_task("ur10_move");
  task.duration = 0.4;
  const PlannedTrajectory planned = from_afar(plan_problem(task));
  ASSERT_EQ(planned.result.status, PlanStatus::kInfeasible);
  const WorstViolation worst = worst_violation(planned);
  EXPECT_THAT(
      sentence(worst),
      testing::ContainsRegex("goal of (elbow|wrist_2)_joint position is missed by 0\\.[0-9]+ rad at 0.4 s"));
  const PlanProblem problem = plan_problem(task);
  const TrajectoryProgram program(problem.task(problem.grid));
  int torques = 0;
  for (Eigen::Index row = 0; row < program.rows.rows(); ++row) {
    const RowMeaning meaning = program.meaning(row);
    if (meaning.limit != "torque") continue;
    const double limit =
        task.scenario.robot->joints[static_cast<std::size_t>(task.scenario.robot->joint_index(meaning.part))]
            .limits.effort;
    EXPECT_EQ(meaning.unit, "N m");
    EXPECT_DOUBLE_EQ(program.natural(row, program.bounds.upper[row]), limit);
    ++torques;
  }
  EXPECT_EQ(torques, 6 * problem.grid.knots());
}

/// Point to point on an arm without a scenario of its own: from one fifth of each joint's range to the other.
PlanTask move_of(const std::shared_ptr<const RobotModel>& arm) {
  PlanTask task;
  task.name = "move";
  task.kind = PlanKind::kMove;
  task.scenario = load_scenario("fixed_target");
  task.scenario.robot = arm;
  task.scenario.plant = {};
  task.scenario.start_position.resize(arm->n());
  task.goal.resize(arm->n());
  for (int i = 0; i < arm->n(); ++i) {
    const JointLimits& limits = arm->joints[static_cast<std::size_t>(i)].limits;
    const double lower = limits.has_position ? limits.lower : -1.0;
    const double upper = limits.has_position ? limits.upper : 1.0;
    task.scenario.start_position[i] = lower + 0.2 * (upper - lower);
    task.goal[i] = lower + 0.8 * (upper - lower);
  }
  task.knots = 40;
  return task;
}

TEST(PlanVariants, ArmsOfOneToTwelveJointsMoveNoFasterThanTheirLimits) {
  std::vector<RobotModel> arms{test::seven_joint_arm()};
  for (const int joints : {1, 3, 5, 9, 12}) arms.push_back(test::random_arm(joints, 7, true));
  for (RobotModel& model : arms) {
    const int joints = model.n();
    for (JointInfo& joint : model.joints)
      joint.limits.effort = 2000.0;  // random arms may not carry themselves
    const auto arm = std::make_shared<const RobotModel>(model);
    PlanTask task = move_of(arm);
    const double time = least_time(task);
    const JointVector way = task.goal - task.scenario.start_position;
    EXPECT_GE(time, (way.array().abs() / arm->velocity_limits().array()).maxCoeff()) << joints;
    task.limits.velocity = 0.7;
    EXPECT_GE(least_time(task), time * (1.0 - 1e-6)) << joints;
  }
}

}  // namespace plan_variants_test
}  // namespace armtune::internal
