#include "core/control/laws/position_servo.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/one_joint.hpp"

namespace armtune::internal {
namespace position_servo_test {

constexpr double kPeriod = 0.002;

JointVector one(double value) {
  return JointVector::Constant(1, value);
}

/// q_s'' = g (q_c - q_s - T q_s') over a period by Runge-Kutta's fourth order, which knows no exponential.
void integrate_servo(const ServoGains& gains, double commanded, double& q, double& v) {
  for (int part = 0; part < 8; ++part)
    test::integrate(
        [&](double x, double speed) { return gains.gain * (commanded - x - gains.lookahead_time * speed); },
        kPeriod / 8.0, q, v);
}

// Gains for which its poles are complex, equal, and real.
TEST(PositionServo, MovesAsItsEquationSays) {
  for (const ServoGains gains : {ServoGains{300.0, 0.1}, ServoGains{400.0, 0.1}, ServoGains{2000.0, 0.2}}) {
    PositionServo servo(test::pendulum(), gains, kPeriod);
    servo.start(one(0.3));
    double q = 0.3, v = 0.0;
    for (int k = 0; k < 300; ++k) {
      const double commanded = 0.3 + 0.2 * std::sin(0.02 * k);
      servo.step(one(commanded));
      integrate_servo(gains, commanded, q, v);
      ASSERT_NEAR(servo.position()[0], q, 1e-10) << k;
      ASSERT_NEAR(servo.velocity()[0], v, 1e-9) << k;
    }
  }
}

// The command is constant within a period, so on average it is half a period old.
TEST(PositionServo, LagsByItsLookAheadTimeBehindAConstantVelocity) {
  constexpr double kSpeed = 0.7;
  for (const double lookahead : {0.03, 0.1, 0.2}) {
    PositionServo servo(test::pendulum(), {500.0, lookahead}, kPeriod);
    servo.start(one(0.0));
    double commanded = 0.0;
    for (int k = 0; k < 2000; ++k) {
      commanded = kSpeed * k * kPeriod;
      servo.step(one(commanded));
    }
    const double lag = commanded + kSpeed * kPeriod - servo.position()[0];
    EXPECT_NEAR(lag, kSpeed * (lookahead + 0.5 * kPeriod), 1e-4 * lag);
  }
}

TEST(PositionServo, KeepsTheVelocityLimitAndArrivesWithoutOvershoot) {
  RobotModel arm = test::pendulum();
  arm.joints[0].limits.velocity = 0.5;
  PositionServo servo(arm, {300.0, 0.12}, kPeriod);  // damping ratio above 1
  servo.start(one(1.0));
  double fastest = 0.0, last = 0.0, last_position = 1.0, lowest = 1.0;
  for (int k = 0; k < 4000; ++k) {
    servo.step(one(-0.5));
    const double v = servo.velocity()[0], q = servo.position()[0];
    fastest = std::max(fastest, std::abs(v));
    lowest = std::min(lowest, q);
    if (v == -0.5) {
      EXPECT_NEAR(q - last_position, 0.5 * kPeriod * (v + last), 1e-12);
    }
    last = v;
    last_position = q;
  }
  EXPECT_EQ(fastest, 0.5);
  EXPECT_NEAR(servo.position()[0], -0.5, 1e-6);
  EXPECT_GT(lowest, -0.5 - 1e-9);
}

TEST(PositionServo, AJointWithoutPositionLimitsTakesTheShorterWay) {
  RobotModel arm = test::pendulum();
  for (const bool turns : {false, true}) {
    arm.joints[0].limits.has_position = !turns;
    PositionServo servo(arm, {300.0, 0.1}, kPeriod);
    servo.start(one(3.0));
    for (int k = 0; k < 4000; ++k) servo.step(one(-3.0));
    EXPECT_NEAR(servo.position()[0], turns ? 2.0 * M_PI - 3.0 : -3.0, 1e-6);
  }
}

}  // namespace position_servo_test
}  // namespace armtune::internal
