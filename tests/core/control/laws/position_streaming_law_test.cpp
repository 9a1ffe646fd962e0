#include "core/control/laws/position_streaming_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/control/laws/controller.hpp"
#include "core/control/laws/velocity_drive.hpp"
#include "core/robot/dynamics.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/law_period.hpp"
#include "tests/core/support/one_joint.hpp"

namespace armtune::internal {
namespace position_streaming_law_test {

using test::Period;

// In the first period the servo is where the arm is, so the drives are commanded to stand still.
TEST(PositionStreamingLaw, BeginsWithTheTorqueThatHoldsTheArm) {
  for (RobotModel model : test::all_arms()) {
    for (JointInfo& joint : model.joints) joint.limits.effort = 1e6;
    for (const bool robot_holds : {false, true}) {
      model.compensates_gravity = robot_holds;
      Period p(model, "position_streaming", 61);
      JointVector weight;
      gravity_torque(model.chain, p.arm.poses, weight);
      const DriveGains drives = drive_gains(model);
      const JointVector tau = p.torque();
      const JointVector expected =
          weight - (drives.gain + 0.5 * Period::period * drives.integral).cwiseProduct(p.measured.qd);
      EXPECT_LT((tau - expected).cwiseAbs().maxCoeff(), 1e-9 * (1.0 + tau.cwiseAbs().maxCoeff()))
          << p.where();
      EXPECT_GT(weight.norm(), 1e-3);
    }
  }
}

// The same arm, stream, servo and drives once more in a few lines, from beside the motion. The robot computes
// four torques in each control period, from commands that are late by some control periods.
TEST(PositionStreamingLaw, TheClosedLoopOfOneJointIsThatOfAnIndependentIntegration) {
  RobotModel model = test::pendulum();
  model.drive_velocity_gain = JointVector::Constant(1, 48.0);
  model.drive_velocity_integral = JointVector::Constant(1, 700.0);
  for (const auto& [robot_holds, delay] : {std::pair{false, 0}, {true, 0}, {false, 2}}) {
    model.compensates_gravity = robot_holds;
    const auto arm = std::make_shared<const RobotModel>(model);
    Gains gains = test::one_joint_gains("position_streaming");
    own(gains, "servo_gain")[0] = 900.0;
    own(gains, "servo_lookahead_time")[0] = 0.05;
    own(gains, "servo_position_gain")[0] = 12.0;
    constexpr double kPeriod = 0.008, kStep = 0.002;
    const JointSpline plan = test::one_joint_plan();
    Controller controller(arm, gains, theta_of(arm->chain), kPeriod, TaskMask::kPosition, {500.0, delay});
    ASSERT_EQ(controller.drive_steps(), 4);
    Path path;
    Scene scene;
    scene.path = &path;
    scene.plan = &plan;

    const auto weight = [](double q) { return 3.0 * 9.81 * 0.4 * std::cos(q); };
    JointState state{JointVector::Constant(1, 0.25), JointVector::Zero(1)};
    double q = 0.25, qd = 0.0, servo = 0.25, servo_speed = 0.0, commanded = 0.25, held = weight(0.25);
    double integral = robot_holds ? 0.0 : held;
    JointVector unlimited, limited;
    for (int k = 0; k < 900; ++k) {
      const double time = k * kStep;
      const bool begins = k % 4 == 0;
      double tau = 0.0;
      if (begins) {
        tau = controller.update(state, scene, time).torque[0];
      } else {
        controller.drive(state, unlimited, limited);
        tau = limited[0];
      }

      if (begins && k / 4 >= delay)
        commanded = plan.at(static_cast<double>(k / 4 - delay) * kPeriod).position[0];
      if (begins) held = weight(q);
      const double from = servo;
      for (int part = 0; part < 8; ++part)
        test::integrate([&](double x, double v) { return 900.0 * (commanded - x - 0.05 * v); }, kStep / 8.0,
                        servo, servo_speed);
      const double slip = (servo - from) / kStep + 12.0 * (from - q) - qd;
      integral += 700.0 * kStep * slip;
      const double own_tau = 48.0 * slip + integral + (robot_holds ? held : 0.0);
      ASSERT_NEAR(tau, own_tau, 1e-7 * (1.0 + std::abs(own_tau))) << time;

      test::integrate([&](double x, double v) { return test::pendulum_acceleration(own_tau, x, v); }, kStep,
                      q, qd);
      test::integrate([&](double x, double v) { return test::joint_acceleration(*arm, tau, x, v); }, kStep,
                      state.q[0], state.qd[0]);
      ASSERT_NEAR(state.q[0], q, 1e-9) << time;
      ASSERT_NEAR(state.qd[0], qd, 1e-8) << time;
    }
    EXPECT_NEAR(q, plan.at(1.8 - 0.05 - delay * kPeriod).position[0], 0.02)
        << "and the arm follows, late by the look-ahead and the delay";
  }
}

// The values that a robot's file gives: the position gain [1/s], which servo_position_gain / 15 scales, the
// rate of the torque [N m/s], and its delay of two and a half periods of the drives [s].
TEST(PositionStreamingLaw, DrivesLimitAndDelayTheirTorqueAsAnIndependentIntegrationDoes) {
  RobotModel model = test::pendulum();
  model.drive_velocity_gain = JointVector::Constant(1, 48.0);
  model.drive_velocity_integral = JointVector::Constant(1, 700.0);
  model.drive_position_gain = JointVector::Constant(1, 20.0);
  model.drive_torque_rate = JointVector::Constant(1, 1000.0);
  model.drive_delay = JointVector::Constant(1, 0.005);
  for (const bool robot_holds : {false, true}) {
    model.compensates_gravity = robot_holds;
    const auto arm = std::make_shared<const RobotModel>(model);
    Gains gains = test::one_joint_gains("position_streaming");
    own(gains, "servo_gain")[0] = 900.0;
    own(gains, "servo_lookahead_time")[0] = 0.05;
    own(gains, "servo_position_gain")[0] = 12.0;
    constexpr double kPeriod = 0.008, kStep = 0.002;
    const JointSpline plan = test::one_joint_plan();
    Controller controller(arm, gains, theta_of(arm->chain), kPeriod, TaskMask::kPosition, {500.0, 0});
    Path path;
    Scene scene;
    scene.path = &path;
    scene.plan = &plan;

    const auto weight = [](double q) { return 3.0 * 9.81 * 0.4 * std::cos(q); };
    JointState state{JointVector::Constant(1, 0.25), JointVector::Zero(1)};
    double q = 0.25, qd = 0.0, servo = 0.25, servo_speed = 0.0, commanded = 0.25, held = weight(0.25);
    double integral = robot_holds ? 0.0 : held;
    std::vector<double> computed(4, held);
    int limited_periods = 0;
    JointVector unlimited, limited;
    for (int k = 0; k < 900; ++k) {
      const double time = k * kStep;
      double tau = 0.0;
      if (k % 4 == 0) {
        tau = controller.update(state, scene, time).torque[0];
        commanded = plan.at(time).position[0];
        held = weight(q);
      } else {
        controller.drive(state, unlimited, limited);
        tau = limited[0];
      }

      const double from = servo;
      for (int part = 0; part < 8; ++part)
        test::integrate([&](double x, double v) { return 900.0 * (commanded - x - 0.05 * v); }, kStep / 8.0,
                        servo, servo_speed);
      const double slip = (servo - from) / kStep + 20.0 * 12.0 / 15.0 * (from - q) - qd;
      integral += 700.0 * kStep * slip;
      const double wanted = 48.0 * slip + integral + (robot_holds ? held : 0.0);
      const double last = computed.back();
      computed.push_back(std::clamp(wanted, last - 2.0, last + 2.0));  // 1000 N m/s in 2 ms
      if (computed.back() != wanted) ++limited_periods;
      const double own_tau = 0.5 * (computed[computed.size() - 3] + computed[computed.size() - 4]);
      ASSERT_NEAR(tau, own_tau, 1e-7 * (1.0 + std::abs(own_tau))) << time;

      test::integrate([&](double x, double v) { return test::pendulum_acceleration(own_tau, x, v); }, kStep,
                      q, qd);
      test::integrate([&](double x, double v) { return test::joint_acceleration(*arm, tau, x, v); }, kStep,
                      state.q[0], state.qd[0]);
      ASSERT_NEAR(state.q[0], q, 1e-9) << time;
      ASSERT_NEAR(state.qd[0], qd, 1e-8) << time;
    }
    EXPECT_GT(limited_periods, 5) << "the limit acts";
    EXPECT_LT(limited_periods, 300) << "and the arm does not shake";
    EXPECT_NEAR(q, plan.at(1.8 - 0.05).position[0], 0.02);
  }
}

// Each joint has its own position gain.
TEST(PositionStreamingLaw, ThePositionGainsOfTheRobotActJointByJoint) {
  RobotModel model = test::ur10();
  const JointVector gain = JointVector::LinSpaced(6, 5.0, 30.0);
  const JointState state{JointVector::Zero(6), JointVector::Zero(6)};
  const JointVector away = JointVector::Constant(6, 0.01);
  // The servo starts at `away`, where the joints were, so only the position loops ask for a velocity.
  const auto torque = [&](double servo_position_gain) {
    JointDrives drives(model, 0.001, {1000.0, 0}, {300.0, 0.1}, servo_position_gain);
    JointVector tau;
    drives.begin(away, {away, state.qd}, JointVector::Zero(6));
    drives.torque(state, tau);
    return tau;
  };
  model.drive_position_gain = JointVector();
  const JointVector of_one = torque(1.0);
  model.drive_position_gain = gain;
  EXPECT_LT((torque(15.0) - gain.cwiseProduct(of_one)).cwiseAbs().maxCoeff(),
            1e-12 * of_one.cwiseAbs().maxCoeff() * 30.0);
  EXPECT_LT((torque(30.0) - 2.0 * gain.cwiseProduct(of_one)).cwiseAbs().maxCoeff(),
            1e-12 * of_one.cwiseAbs().maxCoeff() * 60.0);
  EXPECT_GT(of_one.minCoeff(), 0.0);
}

}  // namespace position_streaming_law_test
}  // namespace armtune::internal
