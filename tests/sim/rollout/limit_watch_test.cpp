#include "sim/rollout/limit_watch.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace limit_watch_test {

/// An observation of an arm at rest in the middle of its limits.
struct Seen {
  RobotModel arm = test::ur10();
  JointVector q = JointVector::Zero(6);
  JointVector qd = JointVector::Zero(6);
  ControlOutput control;
  Observation o;
  LimitWatch watch{arm};

  Seen() {
    control.commanded = JointVector::Zero(6);
    o.q = &q;
    o.qd = &qd;
    o.control = &control;
  }
  void look(double time) {
    o.time = time;
    watch.look(o);
  }
  const JointLimits& limits(std::size_t joint) const { return arm.joints[joint].limits; }
};

TEST(LimitWatch, ALimitThatIsReachedIsNotPassed) {
  Seen seen;
  seen.q[0] = seen.limits(0).upper;
  seen.q[1] = seen.limits(1).lower;
  seen.qd[2] = -seen.limits(2).velocity;
  seen.control.commanded[3] = seen.limits(3).effort;
  seen.look(1.0);
  EXPECT_FALSE(seen.watch.any());
  EXPECT_TRUE(seen.watch.broken().empty());
}

TEST(LimitWatch, SeesTheDrivesBetweenControlPeriods) {
  Seen seen;
  seen.look(1.0);
  DriveInstant between{1.001, seen.q, seen.qd, seen.control.commanded, seen.control.commanded};
  between.qd[1] = 1.5 * seen.limits(1).velocity;
  between.commanded[4] = -2.0 * seen.limits(4).effort;
  seen.o.between = {&between, 1};
  seen.look(1.002);
  const std::vector<BrokenLimit> broken = seen.watch.broken();
  ASSERT_EQ(broken.size(), 2U);
  for (const BrokenLimit& one : broken) EXPECT_EQ(one.time, 1.001);
  EXPECT_EQ(broken[0].limit, JointLimit::kVelocity);
  EXPECT_EQ(broken[1].value, -2.0 * seen.limits(4).effort);
}

TEST(LimitWatch, RemembersTheFirstPassOfEachLimitWithJointValueAndSide) {
  Seen seen;
  seen.look(0.0);
  seen.control.commanded[5] = -1.5 * seen.limits(5).effort;
  seen.look(1.0);
  seen.control.commanded[4] = 9.0 * seen.limits(4).effort;  // later and worse: the first one counts
  seen.qd[2] = 1.25 * seen.limits(2).velocity;
  seen.look(2.0);
  seen.q[1] = seen.limits(1).lower - 0.5;
  seen.look(3.0);
  const std::vector<BrokenLimit> broken = seen.watch.broken();
  ASSERT_EQ(broken.size(), 3U);
  EXPECT_EQ(broken[0].limit, JointLimit::kEffort);
  EXPECT_EQ(broken[0].joint, seen.arm.joints[5].name);
  EXPECT_EQ(broken[0].time, 1.0);
  EXPECT_EQ(broken[0].value, -1.5 * seen.limits(5).effort);
  EXPECT_EQ(broken[0].bound, -seen.limits(5).effort);
  EXPECT_EQ(broken[0].unit, "N m");
  EXPECT_EQ(broken[1].limit, JointLimit::kVelocity);
  EXPECT_EQ(broken[1].joint, seen.arm.joints[2].name);
  EXPECT_EQ(broken[1].bound, seen.limits(2).velocity);
  EXPECT_EQ(broken[1].unit, "rad/s");
  EXPECT_EQ(broken[2].limit, JointLimit::kPosition);
  EXPECT_EQ(broken[2].time, 3.0);
  EXPECT_EQ(broken[2].bound, seen.limits(1).lower);
  EXPECT_EQ(broken[2].unit, "rad");
}

TEST(LimitWatch, FindsAnAccelerationBeyondItsLimitBetweenTwoPeriods) {
  Seen seen;
  seen.arm.joints[2].limits.acceleration = 4.0;
  LimitWatch watch(seen.arm);
  const auto look = [&](double time, double velocity) {
    seen.qd[2] = seen.qd[3] = velocity;  // joint 3 has no limit
    seen.o.time = time;
    watch.look(seen.o);
  };
  look(1.0, -0.5);  // nothing before it to compare with
  look(1.5, 1.4);   // 3.8 rad/s^2
  EXPECT_FALSE(watch.any());
  look(2.0, -0.7);  // -4.2 rad/s^2
  ASSERT_EQ(watch.broken().size(), 1U);
  const BrokenLimit broken = watch.broken().front();
  EXPECT_EQ(broken.limit, JointLimit::kAcceleration);
  EXPECT_EQ(broken.joint, seen.arm.joints[2].name);
  EXPECT_EQ(broken.time, 2.0);
  EXPECT_NEAR(broken.value, -4.2, 1e-12);
  EXPECT_EQ(broken.bound, -4.0);
  EXPECT_EQ(to_string(broken),
            broken.joint + " accelerates at -4.2 rad/s^2, beyond its acceleration limit of -4, at 2.000 s");
}

TEST(LimitWatch, GivesTheLimitsOfASlidingJointInMetresAndNewtons) {
  Seen seen;
  seen.arm.chain.motion[3] = JointMotion::kPrismatic;
  LimitWatch watch(seen.arm);
  seen.qd[3] = 2.0 * seen.limits(3).velocity;
  seen.control.commanded[3] = 2.0 * seen.limits(3).effort;
  watch.look(seen.o);
  const std::vector<BrokenLimit> broken = watch.broken();
  ASSERT_EQ(broken.size(), 2U);
  EXPECT_EQ(broken[0].unit, "m/s");
  EXPECT_EQ(broken[1].unit, "N");
}

TEST(LimitWatch, AShareIsOfVelocityAndEffortAlone) {
  Seen seen;
  LimitWatch watch(seen.arm, 0.9);
  seen.qd[2] = 0.9 * seen.limits(2).velocity;
  seen.control.commanded[5] = -0.9 * seen.limits(5).effort;
  seen.q[1] = 0.95 * seen.limits(1).lower;
  watch.look(seen.o);
  EXPECT_FALSE(watch.any());
  seen.qd[2] = -0.91 * seen.limits(2).velocity;
  seen.control.commanded[5] = 0.91 * seen.limits(5).effort;
  seen.q[1] = seen.limits(1).lower - 1.0;
  watch.look(seen.o);
  const std::vector<BrokenLimit> broken = watch.broken();
  ASSERT_EQ(broken.size(), 3U);
  EXPECT_EQ(broken[0].bound, -0.9 * seen.limits(2).velocity);
  EXPECT_EQ(broken[1].bound, seen.limits(1).lower);
  EXPECT_EQ(broken[2].bound, 0.9 * seen.limits(5).effort);
  EXPECT_EQ(to_string(broken[2]),
            fmt::format("{} is commanded {:.4g} N m, beyond 0.9 of its effort limit of {:.4g}, at 0.000 s",
                        seen.arm.joints[5].name, 0.91 * seen.limits(5).effort, seen.limits(5).effort));
  EXPECT_EQ(to_string(broken[1]).find("0.9 of"), std::string::npos);
}

TEST(LimitWatch, AJointWithoutPositionLimitsNeverPassesThem) {
  Seen seen;
  seen.arm.joints[0].limits.has_position = false;
  LimitWatch watch(seen.arm);
  seen.q[0] = 1e6;
  watch.look(seen.o);
  EXPECT_FALSE(watch.any());
}

/// Over whole rollouts a limit is broken exactly where the metric of the same quantity says so.
TEST(LimitWatch, AgreesWithTheMetrics) {
  for (const double factor : {1.0, 100.0}) {
    const Scenario scenario = test::scenario_of("realistic_fixed_target", 5.0);
    Gains gains = test::quick_gains(scenario);
    gains.task_space_gains_p *= factor;
    LimitWatch watch(*scenario.robot);
    const RolloutResult result =
        Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(gains, [&](const Observation& o) {
          watch.look(o);
          return true;
        });
    bool velocity = false;
    bool position = false;
    bool effort = false;
    for (const BrokenLimit& broken : watch.broken()) {
      velocity = velocity || broken.limit == JointLimit::kVelocity;
      position = position || broken.limit == JointLimit::kPosition;
      effort = effort || broken.limit == JointLimit::kEffort;
    }
    EXPECT_EQ(velocity, result.metrics[Metric::kJointVelocityMaxRatio] > 1.0) << factor;
    EXPECT_EQ(position, result.metrics[Metric::kJointPositionMinMargin] < 0.0) << factor;
    EXPECT_EQ(effort, result.metrics[Metric::kJointEffortMaxRatio] > 1.0) << factor;
    EXPECT_EQ(watch.any(), factor > 1.0) << "a hundredfold Kp saturates, the gains themselves do not";
  }
}

}  // namespace limit_watch_test
}  // namespace armtune::internal
