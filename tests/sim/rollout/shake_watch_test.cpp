#include "sim/rollout/shake_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/core/support/arms.hpp"

namespace armtune::internal {
namespace shake_watch_test {

using Torques = std::function<JointVector(double)>;  ///< as shares of the effort limits, at t

/// What a watch says of 4 s of a UR10 at 500 Hz.
std::optional<Shake> watched(const Torques& shares) {
  const RobotModel arm = test::ur10();
  ShakeWatch watch(arm);
  ControlOutput control;
  Observation o;
  const JointVector rest = JointVector::Zero(6);
  control.reference.velocity = rest;
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
  control.commanded = control.reference.velocity = JointVector::Zero(6);
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

/// What a watch says of 8 s of a UR10 at 500 Hz without torque, whose second joint moves at a share of its
/// velocity limit. desired: whether it should move like this.
std::optional<Shake> watched_moving(const std::function<double(double)>& share, bool desired = false,
                                    ControlState state = ControlState::kFollowTrajectory) {
  const RobotModel arm = test::ur10();
  ShakeWatch watch(arm);
  ControlOutput control;
  control.commanded = control.reference.velocity = JointVector::Zero(6);
  control.state = state;
  Observation o;
  o.control = &control;
  const JointVector q = JointVector::Zero(6);
  JointVector qd = q;
  o.q = &q;
  o.qd = &qd;
  for (int k = 0; k < 4000; ++k) {
    o.time = 0.002 * k;
    qd[1] = share(o.time) * arm.velocity_limits()[1];
    if (desired) control.reference.velocity = qd;
    watch.look(o);
  }
  return watch.first();
}

/// A ringing from 1 s on, at 3 Hz, that grows by a factor of e in 1 / rate seconds.
double ringing(double t, double rate) {
  const double since = t - 1.0;
  return since < 0.0 ? 0.0 : 0.02 * std::exp(rate * since) * std::sin(2.0 * std::numbers::pi * 3.0 * since);
}

TEST(ShakeWatch, NamesASlowOscillationThatGrows) {
  const auto growing = watched_moving([](double t) { return ringing(t, 0.5); });
  ASSERT_TRUE(growing);
  EXPECT_TRUE(growing->growing);
  EXPECT_EQ(growing->joint, "shoulder_lift_joint");
  EXPECT_NEAR(growing->frequency, 3.0, 0.05);
  EXPECT_NEAR(growing->time, 1.0, 0.3);
  EXPECT_NEAR(growing->swing, 2.0 * 0.02 * std::exp(0.5 * 7.0), 0.15);
  EXPECT_EQ(to_string(*growing).find("shoulder_lift_joint oscillates: its velocity swings more and more"),
            0U);
  // On top of a motion that speeds up.
  EXPECT_TRUE(watched_moving([](double t) { return ringing(t, 0.5) + 0.05 * t; }));
}

TEST(ShakeWatch, SaysNothingOfOscillationsThatDoNotGrowOrArePartOfAMotion) {
  const auto growing = [](double t) { return ringing(t, 0.5); };
  EXPECT_FALSE(watched_moving(growing, true)) << "it is the task";
  EXPECT_FALSE(watched_moving(growing, false, ControlState::kLeaveSingularity)) << "on the way to the task";
  EXPECT_TRUE(watched_moving(growing, false, ControlState::kFollowPlan));
  EXPECT_FALSE(watched_moving([](double t) { return ringing(t, -0.5); })) << "it dies away";
  EXPECT_FALSE(watched_moving([](double t) { return 10.0 * ringing(t, -0.5); }));
  EXPECT_FALSE(watched_moving([](double t) { return 10.0 * ringing(t, 0.0); })) << "it stays as it is";
  EXPECT_FALSE(watched_moving([](double t) { return 0.02 * ringing(t, 0.5); })) << "it is too small yet";
  EXPECT_FALSE(watched_moving([](double t) {
    return 0.4 * std::sin(2.0 * std::numbers::pi * t) +
           0.3 * std::sin(2.0 * std::numbers::pi * 1.3 * t + 1.0);
  })) << "a beat of two sines";
  EXPECT_FALSE(watched_moving([](double t) { return t < 4.0 ? 0.1 * t : 0.8 - 0.1 * t; })) << "one motion";
}

TEST(ShakeWatch, IsToldInOneSentence) {
  EXPECT_EQ(
      to_string(Shake{"wrist_3_joint", 0.12, 41.2, 1.84}),
      "wrist_3_joint shakes: its torque swings by 1.8 of its effort limit, at 41.2 Hz, from 0.120 s on");
}

}  // namespace shake_watch_test
}  // namespace armtune::internal
