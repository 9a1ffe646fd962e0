// What the controller does as its states come and go.
#include <gtest/gtest.h>

#include <random>

#include "core/control/laws/controller.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace controller_states_test {

using test::WorstError;

/// An obstacle within the elbow's reach at the goal.
std::vector<Obstacle> obstacle_at_the_elbow(const test::Rig& rig) {
  return {{test::poses_at(rig.model->chain, rig.goal().q).p_0B[2] + Vec3(0.1, 0.1, 0.0)}};
}

TEST(ControllerStates, LeaveSingularityLastsItsDurationThenTheReturnItsOwnThenFollow) {
  test::Rig rig;
  rig.path.center += Vec3(0.06, 0.0, 0.08);  // 0.1 m away: 7 s/m takes 0.7 s
  const std::unique_ptr<Controller> controller = rig.controller();
  double left = -1.0;
  double arrived = -1.0;
  for (int step = 0; step < 1000; ++step) {
    const double time = step * rig.period;
    const ControlState state = controller->update(rig.goal(), rig.scene(), time).state;
    if (left < 0.0 && state != ControlState::kLeaveSingularity) {
      left = time;
      EXPECT_EQ(state, ControlState::kReturnToTrajectory);
    }
    if (arrived < 0.0 && left >= 0.0 && state != ControlState::kReturnToTrajectory) {
      arrived = time;
      EXPECT_EQ(state, ControlState::kFollowTrajectory);
    }
    if (arrived >= 0.0) {
      EXPECT_EQ(state, ControlState::kFollowTrajectory);
    }
  }
  EXPECT_NEAR(left, 0.5, 1e-12);
  EXPECT_NEAR(arrived - left, 0.7, 1.5 * rig.period);  // found at the next period
}

TEST(ControllerStates, LeaveSingularityIsNotInterruptedByAnObstacle) {
  test::Rig rig;
  rig.obstacles = obstacle_at_the_elbow(rig);
  const std::unique_ptr<Controller> controller = rig.controller();
  EXPECT_EQ(controller->update(rig.goal(), rig.scene(), 0.0).state, ControlState::kLeaveSingularity);
  EXPECT_EQ(controller->update(rig.goal(), rig.scene(), 0.498).state, ControlState::kLeaveSingularity);
}

TEST(ControllerStates, TheReturnStartsFromTheMeasuredMotionAndEndsInThePathsOwn) {
  test::Rig rig;
  rig.path.center += Vec3(0.06, 0.0, 0.08);
  rig.path.frequency = 0.5;
  rig.path.terms = {{1, Vec3(0.05, 0, 0), Vec3(0, 0.05, 0)}};
  const std::unique_ptr<Controller> controller = rig.controller();
  JointState measured = rig.goal();
  measured.qd << 0.1, -0.2, 0.1, 0.05, -0.1, 0.2;
  controller->update(measured, rig.scene(), 0.0);
  const ControlOutput& out = controller->update(measured, rig.scene(), 0.5);
  ASSERT_EQ(out.state, ControlState::kReturnToTrajectory);
  const Poses poses = test::poses_at(rig.model->chain, measured.q);
  const Vec3 v = Vec6(test::tool_jacobian_at(rig.model->chain, measured.q) * measured.qd).head<3>();
  WorstError worst("start", 1e-13);  // rounding
  worst.compare(out.desired.position, poses.p_0T, "position");
  worst.compare(out.desired.velocity, v, "velocity");
  worst.add(out.desired.acceleration.norm(), "acceleration");
  MotionPoint<Vec3> last = out.desired;
  double time = 0.5;
  while (out.state == ControlState::kReturnToTrajectory) {
    last = out.desired;
    controller->update(measured, rig.scene(), time += 1e-3);
    ASSERT_LT(time, 10.0);
  }
  const MotionPoint<Vec3> path = rig.path.at(time - 1e-3);
  EXPECT_LT((last.position - path.position).norm(), 1e-6);  // within 1 ms of the end: third order in it
  EXPECT_LT((last.velocity - path.velocity).norm(), 1e-3);
}

TEST(ControllerStates, AnObstacleWithinTheRadiusStartsAvoidanceAndItsLeavingAReturn) {
  test::Rig rig;
  rig.gains.release_radius = 0.5;
  double time = 0.0;
  const std::unique_ptr<Controller> controller = rig.following(time);
  const auto state_at = [&](double distance) {
    // Beyond the tool, on its axis: the last joint's origin is the nearest one.
    const Poses poses = test::poses_at(rig.model->chain, rig.goal().q);
    rig.obstacles = {{poses.p_0B[5] + distance * poses.R_0T.col(2)}};
    const ControlOutput& out = controller->update(rig.goal(), rig.scene(), time += rig.period);
    EXPECT_NEAR(out.obstacle_distance, distance, 1e-12);
    return out.state;
  };
  EXPECT_EQ(state_at(0.33), ControlState::kFollowTrajectory);
  EXPECT_EQ(state_at(0.32), ControlState::kAvoidObstacles);
  EXPECT_EQ(state_at(0.49), ControlState::kAvoidObstacles);
  EXPECT_EQ(state_at(0.51), ControlState::kReturnToTrajectory);
  EXPECT_EQ(state_at(0.49), ControlState::kReturnToTrajectory);
}

TEST(ControllerStates, WithoutAReleaseRadiusAvoidanceEndsAtTheInfluenceRadius) {
  test::Rig rig;
  EXPECT_EQ(rig.controller()->gains().release_radius, rig.gains.obstacleInfluenceRadius);
}

TEST(ControllerStates, AvoidanceDropsLinearReferencesAndErrorsAndGoesOnWithTheGaze) {
  test::Rig rig;
  double time = 0.0;
  const std::unique_ptr<Controller> controller = rig.following(time);
  rig.obstacles = obstacle_at_the_elbow(rig);
  rig.path.center += Vec3(0.1, 0.1, 0.1);
  rig.p_0G += Vec3(0.03, 0.02, 0.0);
  JointState measured = rig.goal();
  measured.qd << 0.1, -0.2, 0.1, 0.05, -0.1, 0.2;
  for (int step = 0; step < 20; ++step) {
    const ControlOutput& out = controller->update(measured, rig.scene(), time += rig.period);
    ASSERT_EQ(out.state, ControlState::kAvoidObstacles);
    ASSERT_FALSE(out.slerping);
    const CartesianErrors& x = out.errors;
    for (const Vec6* six : {&x.pose, &x.rate, &x.integral, &x.desired_rate, &x.desired_accel}) {
      EXPECT_TRUE(six->head<3>().isZero(0.0));
    }
    EXPECT_GT(x.pose.tail<3>().norm(), 0.03);
    EXPECT_GT(x.rate.tail<3>().norm(), 0.01);
    const Jacobian J = test::tool_jacobian_at(rig.model->chain, measured.q);
    EXPECT_LT(Vec6(J * out.reference.velocity).head<3>().norm(),
              1e-13);  // S is the whole linear motion: damped
  }
}

TEST(ControllerStates, ThetaIsFrozenWhileAvoidingExactlyIfTheOptionSaysSo) {
  for (const bool adapt : {true, false}) {
    test::Rig rig;
    rig.gains.adapt_while_avoiding = adapt;
    double time = 0.0;
    const std::unique_ptr<Controller> controller = rig.following(time);
    rig.p_0G += Vec3(0.03, 0.02, 0.0);
    ParameterVector before = controller->theta();
    controller->update(rig.goal(), rig.scene(), time += rig.period);
    EXPECT_NE(controller->theta(), before);
    rig.obstacles = obstacle_at_the_elbow(rig);
    before = controller->theta();
    const ControlOutput& out = controller->update(rig.goal(), rig.scene(), time += rig.period);
    ASSERT_EQ(out.state, ControlState::kAvoidObstacles);
    ASSERT_FALSE(out.saturated);
    EXPECT_EQ(controller->theta() != before, adapt);
  }
}

TEST(ControllerStates, TheIntegralRunsOverTimeAndIsEmptyAfterEveryChangeOfState) {
  test::Rig rig;
  double time = 0.0;
  const std::unique_ptr<Controller> controller = rig.following(time);
  rig.path.center += Vec3(0.01, -0.02, 0.015);
  rig.p_0G += Vec3(0.02, 0.01, 0.0);
  WorstError worst("integral", 1e-12);  // rounding of 50 sums
  // The first period in followTrajectory was without an error, and started the integral at zero.
  Vec6 sum = controller->update(rig.goal(), rig.scene(), time).errors.integral;
  EXPECT_LT(sum.norm(), 1e-12);
  sum += rig.period * controller->update(rig.goal(), rig.scene(), time).errors.pose;
  for (int step = 0; step < 50; ++step) {
    const ControlOutput& out = controller->update(rig.goal(), rig.scene(), time += rig.period);
    sum += rig.period * out.errors.pose;
    worst.compare(out.errors.integral, sum, "followTrajectory", 1e-6);
  }
  EXPECT_GT(sum.head<3>().norm(), 1e-3);
  rig.obstacles = obstacle_at_the_elbow(rig);
  const ControlOutput& avoiding = controller->update(rig.goal(), rig.scene(), time += rig.period);
  ASSERT_EQ(avoiding.state, ControlState::kAvoidObstacles);
  EXPECT_TRUE(avoiding.errors.integral.isZero(0.0));
  EXPECT_GT(controller->update(rig.goal(), rig.scene(), time += rig.period).errors.integral.norm(), 0.0);
  rig.obstacles.clear();
  const ControlOutput& returning = controller->update(rig.goal(), rig.scene(), time += rig.period);
  ASSERT_EQ(returning.state, ControlState::kReturnToTrajectory);
  EXPECT_TRUE(returning.errors.integral.isZero(0.0));
}

TEST(ControllerStates, TheIntegralIsEmptyThroughoutASlerpAndStartsAnewAfterIt) {
  test::Rig rig;
  rig.path.center += Vec3(0.01, -0.02, 0.015);
  double time = 0.0;
  const std::unique_ptr<Controller> controller = rig.following(time);
  for (int step = 0; step < 20; ++step) controller->update(rig.goal(), rig.scene(), time += rig.period);
  const Vec3 straight_ahead = rig.p_0G;
  rig.p_0G += Vec3(0.3, 0.2, 0.0);
  const double start = time + rig.period;
  int slerps = 0;
  bool slerping = true;
  while (slerping) {
    const ControlOutput& out = controller->update(rig.goal(), rig.scene(), time += rig.period);
    slerping = out.slerping;
    slerps += slerping ? 1 : 0;
    EXPECT_TRUE(out.errors.integral.isZero(0.0)) << time - start;
    if (time - start > 0.1) rig.p_0G = straight_ahead;
    ASSERT_LT(time - start, 10.0);
  }
  EXPECT_GT(slerps, 100);
  EXPECT_GT(controller->update(rig.goal(), rig.scene(), time += rig.period).errors.integral.norm(), 0.0);
}

TEST(ControllerStates, ReportsManipulabilityAndWhetherTheInverseIsDamped) {
  test::Rig rig;
  const std::unique_ptr<Controller> controller = rig.controller();
  EXPECT_FALSE(controller->update(rig.goal(), rig.scene(), 0.0).damped);
  JointState stretched{JointVector::Zero(6), JointVector::Zero(6)};
  const ControlOutput& out = controller->update(stretched, rig.scene(), 0.002);
  EXPECT_TRUE(out.damped);
  EXPECT_LT(out.manipulability, 1e-6);
}

}  // namespace controller_states_test
}  // namespace armtune::internal
