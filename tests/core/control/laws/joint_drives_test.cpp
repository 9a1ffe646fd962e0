#include "core/control/laws/joint_drives.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "core/control/laws/controller.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/allocation_counter.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/one_joint.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace joint_drives_test {

using test::random_vector;

TEST(StepsIn, AreTheFewestThatReachTheFrequency) {
  EXPECT_EQ(steps_in(0.002, 1000.0), 2);
  EXPECT_EQ(steps_in(0.008, 1000.0), 8);
  EXPECT_EQ(steps_in(1.0 / 125.0, 500.0), 4);
  EXPECT_EQ(steps_in(1.0 / 3.0, 3.0), 1) << "rounding adds no step";
  EXPECT_EQ(steps_in(0.0021, 1000.0), 3);
  EXPECT_EQ(steps_in(0.002, 100.0), 1) << "a slower rate than the controller's";
  EXPECT_EQ(steps_in(0.002, 0.0), 1);
}

// One control period in five steps is what five control periods of a step each are, as long as the command
// and the weight stay the same.
TEST(JointDrives, DivideAControlPeriodIntoEqualStepsUnderTheSameCommand) {
  std::mt19937 generator(954);
  for (RobotModel arm : test::all_arms()) {
    for (JointInfo& joint : arm.joints) joint.limits.effort = 1e6;
    for (const bool robot_holds : {false, true}) {
      arm.compensates_gravity = robot_holds;
      const JointVector weight = random_vector(generator, arm.n(), 10.0);
      for (const bool positions : {false, true}) {
        const ServoGains servo{400.0, 0.08};
        JointDrives long_period = positions ? JointDrives(arm, 0.005, {1000.0, 0}, servo, 15.0)
                                            : JointDrives(arm, 0.005, {1000.0, 0});
        JointDrives short_period = positions ? JointDrives(arm, 0.001, {1000.0, 0}, servo, 15.0)
                                             : JointDrives(arm, 0.001, {1000.0, 0});
        ASSERT_EQ(long_period.steps(), 5);
        ASSERT_EQ(short_period.steps(), 1);
        for (int k = 0; k < 4; ++k) {
          const JointVector command = random_vector(generator, arm.n(), 0.5);
          for (int step = 0; step < 5; ++step) {
            const JointState state{random_vector(generator, arm.n(), 0.5),
                                   random_vector(generator, arm.n(), 0.5)};
            if (step == 0) long_period.begin(command, state, weight);
            short_period.begin(command, state, weight);
            JointVector a, b;
            long_period.torque(state, a);
            short_period.torque(state, b);
            EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-9 * (1.0 + b.cwiseAbs().maxCoeff())) << arm.name;
          }
        }
      }
    }
  }
}

// Until the first command arrives, the arm is to stand where it is: at rest there, the torque is its weight.
TEST(JointDrives, HoldTheArmUntilTheFirstCommandArrives) {
  std::mt19937 generator(955);
  const RobotModel arm = test::ur10();
  const JointVector weight = random_vector(generator, 6, 20.0), away = random_vector(generator, 6, 1.0);
  const JointState rest{random_vector(generator, 6, 1.0), JointVector::Zero(6)};
  for (const bool positions : {false, true}) {
    JointDrives drives = positions ? JointDrives(arm, 0.004, {500.0, 3}, {400.0, 0.08}, 15.0)
                                   : JointDrives(arm, 0.004, {500.0, 3});
    for (int k = 0; k < 5; ++k) {
      drives.begin(JointVector(rest.q + away), rest, weight);
      for (int step = 0; step < drives.steps(); ++step) {
        JointVector tau;
        drives.torque(rest, tau);
        const double apart = (tau - weight).cwiseAbs().maxCoeff();
        if (k < 3) {
          EXPECT_EQ(apart, 0.0) << k;
        } else {
          EXPECT_GT(apart, 1e-3) << k;
        }
      }
    }
  }
}

TEST(JointDrives, AllocateNothing) {
  if (!test::allocations_are_counted()) GTEST_SKIP() << "a sanitizer owns malloc";
  std::mt19937 generator(956);
  const RobotModel arm = test::ur10();
  JointDrives drives(arm, 0.008, {500.0, 2}, {400.0, 0.08}, 15.0);
  const JointState state{random_vector(generator, 6, 1.0), random_vector(generator, 6, 1.0)};
  const JointVector command = random_vector(generator, 6, 1.0), weight = random_vector(generator, 6, 10.0);
  JointVector tau;
  const long before = test::allocations();
  for (int k = 0; k < 3; ++k) {
    drives.begin(command, state, weight);
    for (int step = 0; step < drives.steps(); ++step) drives.torque(state, tau);
  }
  EXPECT_EQ(test::allocations(), before);
}

TEST(JointDrives, TorquesBetweenControlPeriodsAreWithinTheEffortLimits) {
  RobotModel model = test::pendulum();
  model.drive_velocity_gain = JointVector::Constant(1, 50.0);
  model.drive_velocity_integral = JointVector::Zero(1);
  model.joints[0].limits.effort = 100.0;
  const auto arm = std::make_shared<const RobotModel>(model);
  const JointSpline plan = test::one_joint_plan();
  Controller controller(arm, test::one_joint_gains("joint_trajectory_controller_velocity"),
                        theta_of(arm->chain), 0.004, TaskMask::kPosition, {500.0, 0});
  Path path;
  Scene scene;
  scene.path = &path;
  scene.plan = &plan;
  const JointState still{JointVector::Constant(1, 0.2), JointVector::Zero(1)};
  const JointState pushed{JointVector::Constant(1, 0.2), JointVector::Constant(1, -4.0)};
  const ControlOutput& out = controller.update(still, scene, 0.0);
  EXPECT_FALSE(out.saturated);
  JointVector commanded, torque;
  controller.drive(still, commanded, torque);
  EXPECT_NEAR(commanded[0], out.commanded[0], 1e-9) << "the same state, command and no integral";
  EXPECT_EQ(torque, commanded);
  controller.update(still, scene, 0.004);
  controller.drive(pushed, commanded, torque);
  EXPECT_GT(commanded[0], 200.0) << "50 N m s/rad at 4 rad/s, and the weight";
  EXPECT_EQ(torque[0], 100.0);
}

// Obstacles push in every period of the drives as they do in the control period.
TEST(JointDrives, TheRepulsionOfObstaclesActsBetweenControlPeriodsToo) {
  RobotModel model = test::ur10();
  for (JointInfo& joint : model.joints) joint.limits.effort = 1e6;
  model.drive_velocity_integral = JointVector::Zero(6);
  const auto arm = std::make_shared<const RobotModel>(model);
  Gains gains;
  change_controller(gains, "joint_trajectory_controller_velocity", 6);
  gains.joint_space_gains_p = gains.joint_space_gains_d = gains.joint_space_goal = JointVector::Zero(6);
  gains.joint_trajectory_duration = 1.0;
  gains.force_control_gains = JointVector::Constant(6, 3000.0);
  gains.obstacleInfluenceRadius = 2.0;
  gains.release_radius = 3.0;
  const JointState still{JointVector::Constant(6, 0.4), JointVector::Zero(6)};
  const MotionPoint<JointVector> rest{still.q, still.qd, still.qd};
  const JointSpline plan({0.0, 1.0}, {rest, rest});
  Path path;
  Scene scene;
  scene.path = &path;
  scene.plan = &plan;
  const Obstacle near{Vec3(0.4, 0.1, 0.2), 0.0};
  const auto torques = [&](bool obstacle) {
    Controller controller(arm, gains, theta_of(arm->chain), 0.004, TaskMask::kPose, {500.0, 0});
    scene.obstacles = {&near, obstacle ? 1U : 0U};
    const JointVector first = controller.update(still, scene, 0.0).commanded;
    JointVector commanded, torque;
    controller.drive(still, commanded, torque);
    return std::pair{first, commanded};
  };
  const auto [free_first, free_next] = torques(false);
  const auto [pushed_first, pushed_next] = torques(true);
  EXPECT_LT((free_next - free_first).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((pushed_next - pushed_first).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_GT((pushed_first - free_first).cwiseAbs().maxCoeff(), 10.0) << "the obstacle pushes";
}

}  // namespace joint_drives_test
}  // namespace armtune::internal
