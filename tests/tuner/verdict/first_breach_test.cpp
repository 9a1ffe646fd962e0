#include "tuner/verdict/first_breach.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sim/rollout/limit_watch.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace first_breach_test {

/// What a watch of the arm's own limits sees first, of one kind.
std::optional<BrokenLimit> watched(const Scenario& scenario, const Gains& gains, JointLimit kind) {
  LimitWatch watch(*scenario.robot);
  Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(gains, [&watch](const Observation& o) {
    watch.look(o);
    return true;
  });
  for (const BrokenLimit& broken : watch.broken()) {
    if (broken.limit == kind) return broken;
  }
  return std::nullopt;
}

class FirstBreach : public ::testing::Test {
 protected:
  const test::ShortStudy files_;
  Study study_ = load_study(files_.path());
};

/// At the arm's own limits the breach is the one that LimitWatch, another code, sees first.
TEST_F(FirstBreach, IsThatOfTheLimitWatchWhereTheLimitIsTheArmsOwn) {
  study_.robust.reset();
  const Scenario scenario = test::scenario_of("realistic_fixed_target", 5.0);
  Gains gains = test::quick_gains(scenario);
  gains.task_space_gains_d *= 40.0;
  gains.joint_space_gains_d *= 40.0;
  const auto effort = watched(scenario, gains, JointLimit::kEffort);
  ASSERT_TRUE(effort);
  const auto breach = first_breach(study_, scenario, gains, {Metric::kJointEffortMaxRatio, 1.0});
  ASSERT_TRUE(breach);
  EXPECT_EQ(breach->joint, effort->joint);
  EXPECT_DOUBLE_EQ(breach->time, effort->time);
  const auto velocity = watched(scenario, gains, JointLimit::kVelocity);
  const auto fast = first_breach(study_, scenario, gains, {Metric::kJointVelocityMaxRatio, 1.0});
  ASSERT_EQ(fast.has_value(), velocity.has_value());
  if (fast) {
    EXPECT_EQ(fast->joint, velocity->joint);
    EXPECT_DOUBLE_EQ(fast->time, velocity->time);
  }
}

/// A joint limit that is moved to where the arm goes is passed by that joint, on either side.
TEST_F(FirstBreach, NamesTheJointThatPassesItsPositionLimit) {
  study_.robust.reset();
  int passed = 0;
  for (const double side : {1.0, -1.0}) {
    Scenario scenario = test::scenario_of("realistic_fixed_target", 5.0);
    const Gains gains = test::quick_gains(scenario);
    RobotModel robot = *scenario.robot;
    JointLimits& elbow = robot.joints[2].limits;
    const double start = scenario.start_position[2];
    (side > 0.0 ? elbow.upper : elbow.lower) = start + side * 0.01;
    scenario.robot = std::make_shared<const RobotModel>(robot);
    const auto broken = watched(scenario, gains, JointLimit::kPosition);
    const auto breach = first_breach(study_, scenario, gains, {Metric::kJointPositionMinMargin, 0.0});
    ASSERT_EQ(breach.has_value(), broken.has_value());
    if (!broken) continue;
    ++passed;
    EXPECT_EQ(breach->joint, robot.joints[2].name);
    EXPECT_DOUBLE_EQ(breach->time, broken->time);
    EXPECT_TRUE(breach->arm.empty()) << "there is one";
  }
  EXPECT_GE(passed, 1) << "the elbow goes to one side at least";
}

TEST_F(FirstBreach, IsTheEarliestOfTheArmsOfARobustStudy) {
  const Scenario scenario = test::scenario_of("realistic_fixed_target", 5.0);
  const Gains gains = test::quick_gains(scenario);
  study_.robust = SampleSet();
  study_.robust->samples = 3;
  study_.robust->perturbation.mass = 0.5;
  const EndLimit limit{Metric::kJointVelocityMaxRatio, 0.05};
  double earliest = scenario.duration;
  std::string name;
  for (std::size_t k = 0; k < arms(*study_.robust); ++k) {
    const Scenario arm = arm_of(*study_.robust, scenario, k);
    const RolloutResult result = Rollout(arm, Stepper::kMidpoint, Engine::kNative).run(gains, {}, {limit});
    ASSERT_EQ(result.status, RolloutStatus::kHopeless);
    if (result.end_time >= earliest) continue;
    earliest = result.end_time;
    name = k < 3 ? fmt::format("random arm {} of 3", k + 1) : "the scenario's own arm";
  }
  const auto breach = first_breach(study_, scenario, gains, limit);
  ASSERT_TRUE(breach);
  EXPECT_NEAR(breach->time, earliest, 1.5 * scenario.control_period);
  EXPECT_EQ(breach->arm, name);
}

TEST_F(FirstBreach, IsNoneWhereNothingBreaksOrNothingCanBeSaidWhileARolloutRuns) {
  study_.robust.reset();
  const Scenario scenario = test::scenario_of("realistic_fixed_target", 5.0);
  const Gains gains = test::quick_gains(scenario);
  EXPECT_FALSE(first_breach(study_, scenario, gains, {Metric::kJointVelocityMaxRatio, 1e3}));
  EXPECT_FALSE(first_breach(study_, scenario, gains, {Metric::kEffortRateRms, 1.0}));
  const auto clear = first_breach(study_, scenario, gains, {Metric::kOrientationMax, 0.0});
  ASSERT_TRUE(clear);
  EXPECT_TRUE(clear->joint.empty()) << "no joint has that error";
}

}  // namespace first_breach_test
}  // namespace armtune::internal
