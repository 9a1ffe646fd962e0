#include "sim/rollout/shake_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/core/support/arms.hpp"

namespace armtune::internal {
namespace {

using Torques = std::function<JointVector(double)>;  ///< as shares of the effort limits, at t

/// What a watch says of 4 s of a UR10 at 500 Hz.
std::optional<Shake> watched(const Torques& shares) {
  const RobotModel arm = test::ur10();
  ShakeWatch watch(arm);
  ControlOutput control;
  Observation o;
  const JointVector rest = JointVector::Zero(6);
  o.control = &control;
  o.q = o.qd = &rest;
  for (int k = 0; k < 2000; ++k) {
    o.time = 0.002 * k;
    control.commanded = shares(o.time).cwiseProduct(arm.effort_limits());
    watch.look(o);
  }
  return watch.first();
}

/// One joint's torque swings about 0.1 of its limit from a time on; the others rest.
Torques swinging(Eigen::Index joint, double amplitude, double frequency, double from, double to = 1e9) {
  return [=](double t) {
    JointVector shares = JointVector::Zero(6);
    shares[joint] = 0.1;
    if (t >= from && t < to)
      shares[joint] += amplitude * std::sin(2.0 * std::numbers::pi * frequency * (t - from));
    return shares;
  };
}

TEST(ShakeWatch, NamesJointFrequencySwingAndBeginningOfATorqueThatSwings) {
  for (const double frequency : {6.0, 20.0, 60.0}) {
    const auto shake = watched(swinging(4, 0.4, frequency, 1.0));
    ASSERT_TRUE(shake) << frequency;
    EXPECT_EQ(shake->joint, "wrist_2_joint");
    EXPECT_NEAR(shake->frequency, frequency, 0.02 * frequency);
    EXPECT_NEAR(shake->swing, 0.8, 0.02);
    // The first turn is a quarter of a period after the beginning.
    EXPECT_NEAR(shake->time, 1.0 + 0.25 / frequency, 0.003 + 0.5 / frequency);
  }
}

// A torque that changes its sign in every period of the drives is the same in every control period.
TEST(ShakeWatch, SeesTheTorquesOfDrivesBetweenControlPeriods) {
  const RobotModel arm = test::ur10();
  ShakeWatch watch(arm);
  ControlOutput control;
  control.commanded = JointVector::Zero(6);
  const JointVector rest = JointVector::Zero(6);
  DriveInstant between{0.0, rest, rest, rest, rest};
  between.commanded[2] = 0.9 * arm.effort_limits()[2];
  Observation o;
  o.control = &control;
  o.q = o.qd = &rest;
  for (int k = 0; k < 100; ++k) {
    o.time = 0.002 * k;
    between.time = o.time - 0.001;
    o.between = {&between, k == 0 ? 0U : 1U};
    watch.look(o);
  }
  const auto shake = watch.first();
  ASSERT_TRUE(shake);
  EXPECT_EQ(shake->joint, arm.joints[2].name);
  EXPECT_NEAR(shake->frequency, 500.0, 1.0);
  EXPECT_NEAR(shake->swing, 0.9, 1e-12);
}

TEST(ShakeWatch, SaysNothingOfTorquesThatAreSlowSmallOrSoonAtRest) {
  EXPECT_FALSE(watched(swinging(2, 0.8, 3.0, 0.5))) << "3 Hz is a motion";
  EXPECT_FALSE(watched(swinging(2, 0.2, 20.0, 0.5))) << "a swing of 0.4 of the limit";
  EXPECT_FALSE(watched(swinging(2, 0.8, 20.0, 0.5, 0.7))) << "four periods";
  EXPECT_TRUE(watched(swinging(2, 0.8, 20.0, 0.5, 0.85))) << "seven of them";
  EXPECT_FALSE(watched([](double) { return JointVector(JointVector::Zero(6)); }));
  // A torque that is pushed up and stays there turns once.
  EXPECT_FALSE(watched([](double t) { return JointVector(JointVector::Constant(6, t < 1.0 ? -0.9 : 0.9)); }));
}

// Beyond its limit a torque is cut off, and only what is left swings.
TEST(ShakeWatch, CutsTorquesOffAtTheLimit) {
  const auto shake = watched(swinging(1, 40.0, 10.0, 0.0));
  ASSERT_TRUE(shake);
  EXPECT_EQ(shake->swing, 2.0);
  EXPECT_FALSE(watched([](double t) {
    return JointVector(JointVector::Constant(6, 3.0 + std::sin(60.0 * t)));
  })) << "never below the limit";
}

TEST(ShakeWatch, OfSeveralJointsTheFirstIsTheCauseAndOfThoseThatBeginTogetherTheFastest) {
  const auto both = [](const Torques& a, const Torques& b) {
    return watched([=](double t) { return JointVector(a(t) + b(t)); });
  };
  EXPECT_EQ(both(swinging(0, 0.6, 50.0, 2.0), swinging(5, 0.6, 8.0, 1.0))->joint, "wrist_3_joint");
  EXPECT_EQ(both(swinging(0, 0.6, 8.0, 1.0), swinging(5, 0.6, 50.0, 1.0))->joint, "wrist_3_joint");
  EXPECT_EQ(both(swinging(0, 0.6, 50.0, 1.0), swinging(5, 0.6, 8.0, 1.0))->joint, "shoulder_pan_joint");
}

TEST(ShakeWatch, IsToldInOneSentence) {
  EXPECT_EQ(
      to_string(Shake{"wrist_3_joint", 0.12, 41.2, 1.84}),
      "wrist_3_joint shakes: its torque swings by 1.8 of its effort limit, at 41.2 Hz, from 0.120 s on");
}

}  // namespace
}  // namespace armtune::internal
