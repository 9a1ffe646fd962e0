#include "tuner/verdict/rollout_checks.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "sim/scenario/robot_file.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace rollout_checks_test {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

ScenarioResult result_of(const std::string& scenario, std::vector<BrokenLimit> broken) {
  ScenarioResult result{scenario, {}, std::move(broken)};
  return result;
}

TEST(RolloutChecks, FailWhereAnObstacleIsTouchedAndSayNothingWithoutObstacles) {
  ScenarioResult free = result_of("free", {});
  ScenarioResult near = result_of("near", {});
  ScenarioResult inside = result_of("inside", {});
  free.result.metrics[Metric::kObstacleMinClearance] = NAN;
  near.result.metrics[Metric::kObstacleMinClearance] = 0.02;
  inside.result.metrics[Metric::kObstacleMinClearance] = -0.06;
  const Scenario empty = test::scenario_of("moving_target");
  const Scenario points = test::scenario_of("obstacle_pass");
  Scenario balls = points;
  for (MovingObstacle& obstacle : balls.obstacles) obstacle.radius = 0.1;
  SimulationVerdict none, of_points, kept, touched;
  add_contact_checks({empty}, {free}, "", none);
  EXPECT_TRUE(none.checks.empty());
  add_contact_checks({points}, {near}, "", of_points);
  EXPECT_TRUE(of_points.checks.empty()) << "a check that cannot fail";
  add_contact_checks({empty, balls}, {free, near}, "", kept);
  ASSERT_EQ(kept.checks.size(), 1U);
  EXPECT_EQ(kept.checks.back().kind, CheckKind::kContact);
  EXPECT_TRUE(kept.passed());
  add_contact_checks({balls, balls, empty}, {near, inside, free}, "", touched);
  EXPECT_FALSE(touched.passed());
  EXPECT_EQ(touched.checks.back().scenario, "inside");
  EXPECT_EQ(touched.checks.back().value, -0.06);
}

TEST(RolloutChecks, AnEstimateOfTheRotorsIsNotCheckedByASimulation) {
  Scenario scenario = load_scenario("moving_target");
  const auto not_checked = [&] {
    SimulationVerdict verdict;
    add_unchecked({scenario}, true, verdict);
    return verdict.not_checked;
  };
  EXPECT_THAT(not_checked(), Not(Contains(HasSubstr("rotor"))));
  scenario.robot = load_robot("panda");
  EXPECT_THAT(not_checked(), Contains(HasSubstr("rotor inertia that differs from the estimate")));
}

TEST(RolloutChecks, ContactBetweenControlPeriodsIsNotChecked) {
  Scenario scenario = load_scenario("moving_target");
  const auto not_checked = [&] {
    SimulationVerdict verdict;
    add_unchecked_contacts({scenario}, verdict);
    return verdict.not_checked;
  };
  ASSERT_FALSE(scenario.clearance);
  EXPECT_THAT(not_checked(), Not(Contains(HasSubstr("between two control periods"))));
  scenario.clearance = std::make_shared<const ClearanceModel>(scenario.robot, Cell{});
  const double unseen = 1e3 * scenario.clearance->most_unseen(scenario.control_period);
  EXPECT_GT(unseen, 0.1);
  EXPECT_LT(unseen, 50.0);
  EXPECT_THAT(not_checked(), Contains(AllOf(HasSubstr("between two control periods"),
                                            HasSubstr(fmt::format("up to {:.2g} mm closer", unseen)))));
}

TEST(RolloutChecks, SayHowToCheckTheArmAgainstItselfIfItHasShapes) {
  Scenario scenario = load_scenario("moving_target");
  ASSERT_FALSE(scenario.clearance);
  const auto not_checked = [&] {
    SimulationVerdict verdict;
    add_unchecked_contacts({scenario}, verdict);
    return verdict.not_checked;
  };
  const auto says_how = Contains(AllOf(HasSubstr("self-collision"), HasSubstr("cell: {}")));
  EXPECT_THAT(not_checked(), says_how);
  RobotModel bare = *scenario.robot;
  bare.shapes.clear();
  scenario.robot = std::make_shared<const RobotModel>(bare);
  EXPECT_THAT(not_checked(), AllOf(Contains(HasSubstr("self-collision")), Not(says_how)));
  scenario.clearance = std::make_shared<const ClearanceModel>(load_robot("ur10"), Cell{});
  EXPECT_THAT(not_checked(), Not(Contains(HasSubstr("self-collision"))));
  // A cell does not help an arm without shapes. Each scenario is named with its own reason.
  Scenario without_shapes = load_scenario("fixed_target");
  without_shapes.robot = std::make_shared<const RobotModel>(bare);
  without_shapes.clearance = std::make_shared<const ClearanceModel>(without_shapes.robot, Cell{});
  SimulationVerdict verdict;
  add_unchecked_contacts({load_scenario("moving_target"), without_shapes}, verdict);
  EXPECT_THAT(verdict.not_checked,
              AllOf(Contains(AllOf(HasSubstr("self-collision"), HasSubstr("cell: {}"),
                                   HasSubstr("moving_target"), Not(HasSubstr("fixed_target")))),
                    Contains(AllOf(HasSubstr("self-collision"), HasSubstr("shapes"),
                                   HasSubstr("fixed_target"), Not(HasSubstr("moving_target"))))));
}

TEST(RolloutChecks, LookAtAccelerationsOnlyIfTheArmLimitsThem) {
  ScenarioResult result = result_of("a", {{JointLimit::kAcceleration, "elbow", 7.0, -9.0, -8.0}});
  result.result.metrics[Metric::kJointAccelerationMaxRatio] = 1.125;
  SimulationVerdict verdict;
  add_rollout_checks({result}, "", verdict);
  ASSERT_EQ(verdict.checks.size(), 6U);
  const Check& check = verdict.checks[4];
  EXPECT_EQ(check.kind, CheckKind::kAccelerationLimit);
  EXPECT_FALSE(check.passed);
  EXPECT_EQ(check.scenario, "a");
  EXPECT_EQ(check.joint, "elbow");
  EXPECT_EQ(check.time, 7.0);
  EXPECT_EQ(check.value, 9.0);
  EXPECT_EQ(check.threshold, 8.0);
  EXPECT_FALSE(verdict.passed());
  result.result.metrics[Metric::kJointAccelerationMaxRatio] = NAN;
  SimulationVerdict without;
  add_rollout_checks({result}, "", without);
  EXPECT_EQ(without.checks.size(), 5U);
}

TEST(RolloutChecks, NameTheEarliestFaultOfEachKindOverTheScenarios) {
  SimulationVerdict verdict;
  add_rollout_checks({result_of("a", {{JointLimit::kEffort, "elbow", 7.0, 200.0, 150.0}}),
                      result_of("b", {{JointLimit::kEffort, "wrist", 3.0, -60.0, -56.0},
                                      {JointLimit::kPosition, "pan", 9.0, -6.5, -6.28}})},
                     "", verdict);
  ASSERT_EQ(verdict.checks.size(), 5U);
  for (const Check& check : verdict.checks) {
    switch (check.kind) {
      case CheckKind::kCompleted:
      case CheckKind::kOscillation:
      case CheckKind::kVelocityLimit:
        EXPECT_TRUE(check.passed);
        break;
      case CheckKind::kEffortLimit:
        EXPECT_FALSE(check.passed);
        EXPECT_EQ(check.scenario, "b");
        EXPECT_EQ(check.joint, "wrist");
        EXPECT_EQ(check.time, 3.0);
        EXPECT_EQ(check.value, 60.0);
        EXPECT_EQ(check.threshold, 56.0);
        break;
      case CheckKind::kPositionLimit:
        EXPECT_FALSE(check.passed);
        EXPECT_EQ(check.value, -6.5);
        EXPECT_EQ(check.threshold, -6.28);
        break;
      default:
        FAIL() << name(check.kind);
    }
  }
}

TEST(RolloutChecks, NoteTheJointThatShakesWithItsScenarioAndSet) {
  ScenarioResult steady = result_of("steady", {});
  ScenarioResult shaking = result_of("shaking", {});
  shaking.shake = Shake{"wrist_1_joint", 0.5, 30.0, 1.2};
  SimulationVerdict verdict;
  add_shake_notes({steady, shaking}, "start gains", verdict);
  EXPECT_THAT(verdict.notes,
              ElementsAre(AllOf(HasSubstr("in shaking under start gains, wrist_1_joint shakes"),
                                HasSubstr("30 Hz"))));
}

TEST(RolloutChecks, AJointThatShakesFailsWithItsScenarioAndTime) {
  ScenarioResult late = result_of("late", {});
  late.shake = Shake{"elbow_joint", 2.5, 3.0, 0.4, true};
  ScenarioResult early = result_of("early", {});
  early.shake = Shake{"wrist_1_joint", 0.5, 30.0, 1.2, false};
  SimulationVerdict verdict;
  add_rollout_checks({result_of("steady", {}), late, early}, "", verdict);
  EXPECT_FALSE(verdict.passed());
  const Check& check = verdict.checks.back();
  EXPECT_EQ(check.kind, CheckKind::kOscillation);
  EXPECT_FALSE(check.passed);
  EXPECT_EQ(check.scenario, "early");
  EXPECT_EQ(check.joint, "wrist_1_joint");
  EXPECT_EQ(check.time, 0.5);
  EXPECT_EQ(check.detail, swing_text(*early.shake));
  EXPECT_THAT(check.detail, HasSubstr("at 30 Hz"));
}

TEST(RolloutChecks, AScenarioThatDidNotCompleteFailsWithItsReason) {
  ScenarioResult broken = result_of("a", {});
  broken.result.status = RolloutStatus::kDiverged;
  broken.result.reason = "diverged at 1 s";
  SimulationVerdict verdict;
  add_rollout_checks({result_of("b", {}), broken}, "tuned", verdict);
  EXPECT_FALSE(verdict.passed());
  EXPECT_EQ(verdict.checks.front().detail, "diverged at 1 s");
  EXPECT_EQ(verdict.checks.front().kind, CheckKind::kCompleted);
  EXPECT_EQ(verdict.checks.front().scenario, "a under tuned");
}

TEST(EnduranceChecks, FailForALimitAndForErrorsThatGrow) {
  const VerdictThresholds thresholds;
  EnduranceResult steady{"steady", 1800.0, {}, "", 1.1, 1.4, Engine::kNative};
  EnduranceResult growing{"growing", 1800.0, {}, "", 1.3, 1.4, Engine::kSimbody};
  EnduranceResult breaking{
      "breaking", 527.0,           BrokenLimit{JointLimit::kEffort, "wrist", 527.0, 94.0, 56.0}, "", NAN,
      NAN,        Engine::kSimbody};
  SimulationVerdict held;
  add_endurance_checks({steady}, thresholds, "", held);
  EXPECT_TRUE(held.passed());
  SimulationVerdict grew;
  add_endurance_checks({steady, growing}, thresholds, "", grew);
  EXPECT_FALSE(grew.passed());
  EXPECT_TRUE(grew.checks[0].passed);
  EXPECT_EQ(grew.checks[1].scenario, "growing");
  SimulationVerdict broke;
  add_endurance_checks({steady, breaking}, thresholds, "", broke);
  EXPECT_FALSE(broke.checks[0].passed);
  EXPECT_EQ(broke.checks[0].joint, "wrist");
  EXPECT_EQ(broke.checks[0].time, 527.0);
  EXPECT_TRUE(broke.checks[1].passed) << "a rollout that broke off has no last minutes";
  // Nothing was tracked, or nothing came to its end: no sentence about growth is true.
  for (const EnduranceResult& nothing : {EnduranceResult{"idle", 1800.0, {}, "", NAN, NAN}, breaking}) {
    SimulationVerdict verdict;
    add_endurance_checks({nothing}, thresholds, "", verdict);
    ASSERT_EQ(verdict.checks.size(), 1U);
    EXPECT_EQ(verdict.checks[0].kind, CheckKind::kEndurance);
    EXPECT_THAT(verdict.not_checked, ElementsAre(HasSubstr("error growth")));
  }
}

}  // namespace rollout_checks_test
}  // namespace armtune::internal
