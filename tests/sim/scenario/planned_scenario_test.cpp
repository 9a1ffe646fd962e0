// Scenarios that begin with a planned motion.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/scenario.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/planned.hpp"

namespace armtune::internal {
namespace planned_scenario_test {

using test::refused_at;

class PlannedScenario : public testing::Test {
 protected:
  PlannedScenario() {
    plan_.start = JointVector::Constant(6, -0.5);
    plan_.goal = JointVector::Constant(6, 0.7);
  }
  std::string csv() const { return test::plan_csv(*robot_, plan_); }
  std::string write(const std::string& text) const { return folder_.write("plan.csv", text); }
  Scenario scenario(const std::string& keys) const {
    return load_scenario(folder_.write("own.yaml", "base: moving_target\n" + keys));
  }

  test::TemporaryFolder folder_;
  std::shared_ptr<const RobotModel> robot_ = load_robot("ur10");
  test::QuinticPlan plan_;
};

TEST_F(PlannedScenario, BeginsWithTheMotionAndLastsAsLongUnlessItSaysOtherwise) {
  write(csv());
  const Scenario s = scenario("planned: plan.csv\nduration: planned\n");
  EXPECT_EQ(s.start_time, 8.0);
  EXPECT_EQ(s.start_position, plan_.start);
  EXPECT_TRUE(s.start_velocity.isZero(0.0));
  EXPECT_EQ(s.periods(), 1000);
  EXPECT_FALSE(s.has_task());
  EXPECT_THAT(s.inputs, testing::Contains(folder_ / "plan.csv"));

  const Scenario longer = scenario("planned: plan.csv\nduration: 5\n");
  EXPECT_EQ(longer.duration, 5.0);
  EXPECT_TRUE(longer.has_task());
  EXPECT_EQ(scenario("planned: plan.csv\n").duration, 40.0) << "the base's";
  EXPECT_TRUE(scenario("").has_task());
  EXPECT_EQ(scenario("").start_time, 0.0);

  // Not a whole number of periods: the last one is whole.
  plan_.duration = 0.3002;
  plan_.step = 0.0001;
  write(csv());
  const Scenario odd = scenario("planned: plan.csv\nduration: planned\n");
  EXPECT_EQ(odd.periods(), 151);
  EXPECT_FALSE(odd.has_task());
  EXPECT_TRUE(scenario("planned: plan.csv\nduration: 0.304\n").has_task());
}

TEST_F(PlannedScenario, AloneItCanHoldTheEndForAWhile) {
  write(csv());
  const auto alone = [&](const std::string& keys) {
    return load_scenario(folder_.write(
        "alone.yaml",
        "robot: ur10\ncontrol_period: 0.002\nplanned: plan.csv\ntheta_start: {model_scale: 1}\n" + keys));
  };
  EXPECT_FALSE(alone("").holds_goal());
  const Scenario s = alone("hold_end: 0.5\ngoal_tolerance: 0.02\n");
  EXPECT_EQ(s.periods(), 1250);
  EXPECT_TRUE(s.holds_goal());
  EXPECT_FALSE(s.has_task());
  EXPECT_EQ(s.goal_tolerance, 0.02);
  EXPECT_EQ(alone("duration: planned\nhold_end: 0.5\n").periods(), 1250);
  EXPECT_TRUE(alone("duration: 2.002\n").holds_goal());
  EXPECT_FALSE(alone("duration: 2\n").holds_goal());
  EXPECT_THAT([&] { alone("duration: 3\nhold_end: 0.5\n"); },
              refused_at({.line = 6, .key = "hold_end", .value = "0.5", .limit = "duration: planned"}));
  EXPECT_THAT([&] { alone("hold_end: -1\n"); },
              refused_at({.line = 5, .key = "hold_end", .value = "-1", .limit = "0 to 3600"}));
  EXPECT_THAT([&] { alone("goal_tolerance: 0\n"); },
              refused_at({.line = 5, .key = "goal_tolerance", .value = "0", .limit = "1e-06 to 1"}));
  EXPECT_THAT([&] { scenario("planned: plan.csv\nduration: planned\nhold_end: 0.5\n"); },
              refused_at({.file = folder_ / "own.yaml",
                          .line = 4,
                          .key = "hold_end",
                          .value = "0.5",
                          .limit = "a duration in seconds"}));
}

// q(t) becomes q(begin + speed (t - begin)), so its derivatives grow with the speed and its square.
TEST_F(PlannedScenario, TheSpeedOfTheMotionCanBeChanged) {
  write(csv());
  const JointSpline given = *scenario("planned: plan.csv\nduration: planned\n").planned;
  for (const double speed : {0.25, 2.0}) {
    for (const char* segments : {"", ", segments: as_ros"}) {
      const JointSpline base =
          *scenario(fmt::format("planned: {{file: plan.csv{}}}\nduration: planned\n", segments)).planned;
      const Scenario s = scenario(
          fmt::format("planned: {{file: plan.csv, speed: {}{}}}\nduration: planned\n", speed, segments));
      EXPECT_EQ(s.planned->begin(), given.begin());
      EXPECT_NEAR(s.planned->end() - s.planned->begin(), (given.end() - given.begin()) / speed, 1e-12);
      EXPECT_NEAR(s.duration, 2.0 / speed, 1e-9);
      for (double t = given.begin(); t < given.end(); t += 0.0717) {
        const auto slow = s.planned->at(given.begin() + (t - given.begin()) / speed);
        const auto fast = base.at(t);
        EXPECT_LT((slow.position - fast.position).cwiseAbs().maxCoeff(), 1e-9);
        EXPECT_LT((slow.velocity - speed * fast.velocity).cwiseAbs().maxCoeff(), 1e-9);
        EXPECT_LT((slow.acceleration - speed * speed * fast.acceleration).cwiseAbs().maxCoeff(), 1e-8);
      }
    }
  }
  EXPECT_THAT([&] { scenario("planned: {file: plan.csv, speed: 0}\n"); },
              refused_at({.line = 2, .key = "planned/speed", .value = "0", .limit = "0.01 to 10"}));
}

TEST_F(PlannedScenario, WithoutABaseNeedsNeitherDurationNorStart) {
  write(csv());
  const std::string own = folder_.write(
      "whole.yaml",
      "robot: ur10\ncontrol_period: 0.002\nplanned: plan.csv\npath: {center: [-0.65, 0.04, 0.5]}\n"
      "targets: [{name: red, center: [-0.6, 0, 0]}]\ntheta_start: {model_scale: 1}\n");
  EXPECT_EQ(load_scenario(own).periods(), 1000);
}

TEST_F(PlannedScenario, ASwitchOfTargetsAtItsBeginningIsOne) {
  write(csv());
  const auto switching = [&](const std::string& keys) {
    return load_scenario(folder_.write("own.yaml",
                                       "base: target_switch\nplanned: plan.csv\nduration: planned\n" + keys))
        .switches_target();
  };
  EXPECT_TRUE(switching(""));
  EXPECT_TRUE(switching("switch_every: 9\n"));
  EXPECT_FALSE(switching("switch_every: 7\n"));
  EXPECT_FALSE(switching("switch_every: 0\n"));
}

TEST_F(PlannedScenario, WhatDoesNotGoWithItIsRefused) {
  write(csv());
  const std::string step = "stimulus: {on: path, step: {offset: [0, 0, 0.1], at: 9}}\n";
  EXPECT_THAT([&] { scenario("planned: plan.csv\n" + step); },
              refused_at({.line = 3, .key = "stimulus", .limit = "no planned trajectory"}));
  EXPECT_THAT([&] { scenario("duration: planned\n"); }, refused_at({.file = folder_ / "own.yaml",
                                                                    .line = 2,
                                                                    .key = "duration",
                                                                    .value = "planned",
                                                                    .limit = "a duration in seconds"}));
  EXPECT_THAT([&] { scenario("planned: other.csv\n"); }, refused_at({.file = folder_ / "other.csv"}));
  plan_.duration = 1e-3;
  plan_.step = 5e-4;
  plan_.goal = plan_.start;
  write(csv());
  EXPECT_EQ(scenario("planned: plan.csv\nduration: planned\n").periods(), 1);
}

}  // namespace planned_scenario_test
}  // namespace armtune::internal
