#include "tuner/planning/tasks/plan_task.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "armtune/error.hpp"
#include "core/robot/dynamics.hpp"
#include "core/trajectory/gaze.hpp"
#include "sim/scenario/data_files.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tuner/planning/output/binding_limits.hpp"
#include "tuner/planning/output/worst_violation.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune::internal {
namespace plan_task_test {

PlannedTrajectory solved(const PlanProblem& problem) {
  return solve_plan(problem);
}

/// The arm along a plan, by core's own kinematics and dynamics.
struct Along {
  Poses poses;
  Jacobian J, J_dot;
  JointVector q, qd, qdd, tau;

  Along(const PlanProblem& problem, const Trajectory& trajectory, Eigen::Index k) {
    const int n = problem.robot->n();
    q = trajectory.position.col(k).head(n);
    qd = trajectory.velocity.col(k).head(n);
    qdd = trajectory.acceleration.col(k).head(n);
    forward_kinematics(problem.robot->chain, q, poses);
    tool_jacobian(problem.robot->chain, poses, J);
    tool_jacobian_derivative(problem.robot->chain, poses, J, qd, J_dot);
    inverse_dynamics(problem.robot->chain, poses, qd, qdd, tau);
  }
};

/// What every plan has to keep, computed anew: limits at the knots, and a motion without jumps between them.
void expect_within_limits(const PlanTask& task, const PlanProblem& problem,
                          const PlannedTrajectory& planned) {
  ASSERT_EQ(planned.result.status, PlanStatus::kSolved) << task.name;
  EXPECT_LE(planned.result.last.violation, 1e-8);
  EXPECT_LE(planned.result.last.stationarity, 1e-6);
  EXPECT_LE(planned.result.last.complementarity, 1e-6);
  const RobotModel& robot = *problem.robot;
  const Trajectory& t = planned.trajectory;
  for (Eigen::Index k = 0; k < t.position.cols(); ++k) {
    const Along at(problem, t, k);
    for (int i = 0; i < robot.n(); ++i) {
      const JointLimits& limits = robot.joints[static_cast<std::size_t>(i)].limits;
      EXPECT_LE(std::abs(at.qd[i]), limits.velocity * task.limits.velocity * (1.0 + 2e-8));
      EXPECT_LE(std::abs(at.tau[i]), limits.effort * task.limits.effort * (1.0 + 2e-8));
      EXPECT_GE(at.q[i], limits.lower - 1e-7);
      EXPECT_LE(at.q[i], limits.upper + 1e-7);
    }
    for (const MovingObstacle& obstacle : task.scenario.obstacles) {
      if (task.clearance == 0.0) continue;
      const Vec3 center = obstacle.path.at(t.time[static_cast<std::size_t>(k)]).position;
      EXPECT_GE((at.poses.p_0T - center).norm(), task.clearance * (1.0 - 2e-8));
      for (int i = 1; i < robot.n(); ++i) {
        EXPECT_GE((at.poses.p_0B[static_cast<std::size_t>(i)] - center).norm(),
                  task.clearance * (1.0 - 2e-8));
      }
    }
    if (k == 0) continue;
    const double h = t.time[static_cast<std::size_t>(k)] - t.time[static_cast<std::size_t>(k) - 1];
    const Eigen::VectorXd step = t.position.col(k - 1) + h * t.velocity.col(k - 1) +
                                 h * h * (t.acceleration.col(k - 1) / 3.0 + t.acceleration.col(k) / 6.0);
    EXPECT_LE((t.position.col(k) - step).lpNorm<Eigen::Infinity>(), 1e-8);
    // Velocities between the knots as well.
    for (const double part : {0.25, 0.5, 0.75}) {
      const TrajectoryPoint inside = point_at(t, t.time[static_cast<std::size_t>(k)] - part * h);
      for (int i = 0; i < robot.n(); ++i) {
        EXPECT_LE(std::abs(inside.velocity[i]), robot.joints[static_cast<std::size_t>(i)].limits.velocity *
                                                    task.limits.velocity * (1.0 + 1e-7));
      }
    }
  }
}

struct Planned {
  PlanTask task;
  PlanProblem problem;
  PlannedTrajectory planned;
  Eigen::Index last = 0;

  explicit Planned(const std::string& name) : Planned(load_plan_task(name)) {}
  explicit Planned(PlanTask given)
      : task(std::move(given)), problem(plan_problem(task)), planned(solved(problem)) {
    last = planned.trajectory.position.cols() - 1;
    expect_within_limits(task, problem, planned);
  }
  Along at(Eigen::Index k) const { return {problem, planned.trajectory, k}; }
  double time(Eigen::Index k) const { return planned.trajectory.time[static_cast<std::size_t>(k)]; }
};

TEST(PlanTasks, AMoveEndsAtItsGoalAtRestAndNoSlowerThanItsSlowestJointMust) {
  const Planned move("ur10_move");
  const Along end = move.at(move.last);
  EXPECT_LE((end.q - move.task.goal).lpNorm<Eigen::Infinity>(), 1e-7);
  EXPECT_LE(end.qd.lpNorm<Eigen::Infinity>(), 1e-6);
  EXPECT_LE(end.qdd.lpNorm<Eigen::Infinity>(), 1e-5);
  const double at_full_speed = ((move.task.goal - move.task.scenario.start_position).array().abs() /
                                move.problem.robot->velocity_limits().array())
                                   .maxCoeff();
  const double duration = move.planned.trajectory.durations[0];
  EXPECT_GE(duration, at_full_speed);
  EXPECT_LE(duration, 1.05 * at_full_speed);  // rotor inertia and torque limits cost a little
}

TEST(PlanTasks, ASwitchBringsTheGazeUnderItsThresholdAndKeepsItThereWhileTheToolGoesOn) {
  const Planned plan("ur10_switch");
  const Scenario& scenario = plan.task.scenario;
  const MovingPoint target = active_target(scenario);
  const Eigen::Index acquired = plan.planned.program->task().grid.first_knot(1);
  for (Eigen::Index k = 1; k <= plan.last; ++k) {
    const Along at = plan.at(k);
    EXPECT_LE((at.poses.p_0T - scenario.path.at(plan.time(k)).position).lpNorm<Eigen::Infinity>(),
              plan.task.path_tolerance * (1.0 + 2e-8));
    if (k < acquired) continue;
    EXPECT_LE(gaze_angle(at.poses.R_0T, at.poses.p_0T, target(plan.time(k)).position),
              plan.task.gaze_threshold * (1.0 + 1e-6));
  }
  // Before that it was not there: the time is the least.
  const Along before = plan.at(acquired - 2);
  EXPECT_GT(gaze_angle(before.poses.R_0T, before.poses.p_0T, target(plan.time(acquired - 2)).position),
            plan.task.gaze_threshold);
}

TEST(PlanTasks, AReturnEndsOnThePathWithItsVelocityAndAcceleration) {
  const Planned plan("ur10_return");
  const Along end = plan.at(plan.last);
  const MotionPoint<Vec3> path = plan.task.scenario.path.at(plan.time(plan.last));
  EXPECT_LE((end.poses.p_0T - path.position).norm(), 1e-7);
  EXPECT_LE((end.J.topRows<3>() * end.qd - path.velocity).norm(), 1e-7);
  EXPECT_LE((end.J.topRows<3>() * end.qdd + end.J_dot.topRows<3>() * end.qd - path.acceleration).norm(),
            1e-6);
}

TEST(PlanTasks, ALapHasNextToNoError) {
  const Planned plan("ur10_lap");
  const MovingPoint target = active_target(plan.task.scenario);
  for (Eigen::Index k = 0; k <= plan.last; ++k) {
    const Along at = plan.at(k);
    EXPECT_LE((at.poses.p_0T - plan.task.scenario.path.at(plan.time(k)).position).norm(), 1e-5);
    EXPECT_LE(gaze_angle(at.poses.R_0T, at.poses.p_0T, target(plan.time(k)).position), 1e-4);
  }
}

TEST(PlanTasks, TheFastestTurnStaysOnTheCurveFromRestToRest) {
  const Planned plan("ur10_fastest_circle");
  const int n = plan.problem.robot->n();
  double before = -1.0;
  for (Eigen::Index k = 0; k <= plan.last; ++k) {
    const double s = plan.planned.trajectory.position(n, k);
    EXPECT_GE(s, before - 1e-9);
    before = s;
    if (k > 0) {
      EXPECT_LE((plan.at(k).poses.p_0T - plan.task.scenario.path.at(plan.task.at + s).position)
                    .lpNorm<Eigen::Infinity>(),
                plan.task.path_tolerance * (1.0 + 2e-8));
    }
  }
  EXPECT_NEAR(before, 2.0 * M_PI / plan.task.scenario.path.frequency, 1e-7);
  EXPECT_LE(plan.at(plan.last).qd.lpNorm<Eigen::Infinity>(), 1e-7);
}

TEST(PlanTasks, TheLeastGazeErrorIsLessThanThatOfTheFastestSwitch) {
  const Planned fastest("ur10_switch");
  const Planned least("ur10_least_gaze_error");
  const auto error_over = [](const Planned& plan, double seconds) {
    const MovingPoint target = active_target(plan.task.scenario);
    double sum = 0.0;
    for (int i = 0; i <= 200; ++i) {
      const double t = plan.task.at + seconds * i / 200.0;
      const TrajectoryPoint point = point_at(plan.planned.trajectory, t);
      Poses poses;
      forward_kinematics(plan.problem.robot->chain, JointVector(point.position), poses);
      const double angle = gaze_angle(poses.R_0T, poses.p_0T, target(t).position);
      sum += angle * angle * seconds / 200.0;
    }
    return sum;
  };
  const double shared = 0.6;  // s, which both plans cover
  EXPECT_LT(error_over(least, shared), error_over(fastest, shared));
}

TEST(PlanTasks, AMovePastObstaclesKeepsClearOfThemAndWithoutThemItWouldNot) {
  PlanTask task = load_plan_task("ur10_clear_of_obstacles");
  const Planned around(task);  // keeps clear: expect_within_limits
  const double clearance = task.clearance;
  task.clearance = 0.0;
  const Planned straight(task);
  double closest = INFINITY;
  for (Eigen::Index k = 0; k <= straight.last; ++k) {
    const Along at = straight.at(k);
    for (const MovingObstacle& obstacle : task.scenario.obstacles) {
      for (int i = 1; i < straight.problem.robot->n(); ++i) {
        closest = std::min(closest, (at.poses.p_0B[static_cast<std::size_t>(i)] -
                                     obstacle.path.at(straight.time(k)).position)
                                        .norm());
      }
    }
  }
  EXPECT_LT(closest, 0.9 * clearance);
  // The way around takes the joint with the longest way no time; it costs smoothness, more than the residuals
  // leave open.
  EXPECT_GT(around.planned.objective(), straight.planned.objective() + 1e-6);
}

TEST(PlanTasks, AccelerationAndJerkLimitsAreKept) {
  PlanTask task = load_plan_task("ur10_move");
  task.limits.acceleration = JointVector::Constant(6, 8.0);
  task.limits.jerk = JointVector::Constant(6, 100.0);
  task.limits.velocity = 0.5;
  const Planned plan(task);
  const Trajectory& t = plan.planned.trajectory;
  EXPECT_LE(t.acceleration.lpNorm<Eigen::Infinity>(), 8.0 * (1.0 + 2e-8));
  for (Eigen::Index k = 1; k <= plan.last; ++k) {
    const double h = plan.time(k) - plan.time(k - 1);
    EXPECT_LE((t.acceleration.col(k) - t.acceleration.col(k - 1)).lpNorm<Eigen::Infinity>() / h,
              100.0 * (1.0 + 1e-7));
  }
}

TEST(PlanTasks, TheRobotsAccelerationLimitsCountLikeTheTasksOwn) {
  PlanTask own = load_plan_task("ur10_move");
  own.limits.acceleration = JointVector::Constant(6, 8.0);
  PlanTask of_robot = load_plan_task("ur10_move");
  auto limited = std::make_shared<RobotModel>(*of_robot.scenario.robot);
  for (JointInfo& joint : limited->joints) joint.limits.acceleration = 8.0;
  of_robot.scenario.robot = limited;
  const Planned a(own), b(of_robot);
  EXPECT_EQ(a.planned.trajectory.acceleration, b.planned.trajectory.acceleration);
  EXPECT_GT(b.planned.trajectory.acceleration.lpNorm<Eigen::Infinity>(),
            0.99 * 8.0);  // it holds the plan back

  // A joint without either has no limit; a task may be stricter than the robot.
  limited->joints[2].limits.acceleration = std::numeric_limits<double>::infinity();
  EXPECT_EQ(acceleration_limits(of_robot)[2], std::numeric_limits<double>::infinity());
  of_robot.limits.acceleration = JointVector::Constant(6, 5.0);
  EXPECT_EQ(acceleration_limits(of_robot), JointVector::Constant(6, 5.0));
}

TEST(PlanTasks, TooLittleTimeIsInfeasibleAndTheSlowestJointIsNamed) {
  PlanTask task = load_plan_task("ur10_move");
  task.duration = 0.4;  // the elbow alone needs 0.5 s
  const PlanProblem problem = plan_problem(task);
  const PlannedTrajectory planned = solved(problem);
  ASSERT_EQ(planned.result.status, PlanStatus::kInfeasible);
  EXPECT_TRUE(planned.too_short);
  // In so little time the goal is what is missed.
  const PlannedTrajectory missed = solve_refining(problem.task, problem.grid, problem.guess, {}, {});
  ASSERT_EQ(missed.result.status, PlanStatus::kInfeasible);
  EXPECT_EQ(worst_violation(missed).meaning.limit, "goal");
  for (const PlannedTrajectory* plan : {&planned, &missed}) {
    const std::vector<BindingLimit> limits = binding_limits(*plan);
    ASSERT_FALSE(limits.empty());
    EXPECT_EQ(limits.front().limit, "velocity");
    EXPECT_THAT(limits.front().part, testing::AnyOf("elbow_joint", "wrist_2_joint"));
  }
}

TEST(PlanTasks, ARobotIsAskedToReachOnlyWhatItCan) {
  PlanTask task = load_plan_task("ur10_switch");
  task.scenario.path.center = Vec3(3.0, 0.0, 0.5);
  EXPECT_THAT([&] { plan_problem(task); },
              test::refused_at(
                  {.file = shown_path(task.source), .key = "scenario", .value = testing::StartsWith("(3")}));
}

}  // namespace plan_task_test
}  // namespace armtune::internal
