#include "tuner/verdict/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/first_gains.hpp"
#include "core/robot/link_radius.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tuner/study/thresholds.hpp"
#include "tuner/verdict/assumptions.hpp"
#include "tuner/verdict/rollout_checks.hpp"

namespace armtune::internal {
namespace verdict_verdict_test {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Check failed(CheckKind kind, const std::string& scenario, const std::string& joint, double time) {
  return {kind, false, scenario, "", joint, time, 94.25, 56.0, "N m", "a \"quoted\" clause: with, signs"};
}

TEST(SimulationVerdict, WithoutChecksNothingHasPassed) {
  EXPECT_FALSE(SimulationVerdict().passed());
  EXPECT_THAT(to_text(SimulationVerdict()), Not(HasSubstr("passed")));
}

TEST(SimulationVerdict, OneFailureFailsItAndIsNamedWithJointAndTime) {
  SimulationVerdict verdict;
  verdict.checks = {{CheckKind::kCompleted}, {CheckKind::kYield}};
  EXPECT_TRUE(verdict.passed());
  EXPECT_THAT(to_text(verdict), HasSubstr("Simulation checks: passed"));
  verdict.checks.push_back(failed(CheckKind::kEffortLimit, "long", "wrist_1_joint", 527.318));
  EXPECT_FALSE(verdict.passed());
  const std::string text = to_text(verdict);
  EXPECT_THAT(text, HasSubstr("Simulation checks: failed: effort limit, wrist_1_joint, 527.318 s"));
  EXPECT_THAT(text, HasSubstr("long"));
}

TEST(SimulationVerdict, ReadsBackFromItsFileFieldByField) {
  SimulationVerdict verdict;
  for (int kind = 0; kind <= static_cast<int>(CheckKind::kBetterThanStart); ++kind) {
    verdict.checks.push_back({static_cast<CheckKind>(kind)});
    verdict.checks.push_back(failed(static_cast<CheckKind>(kind), "a: b", "joint #1", 0.1 * kind));
    verdict.checks.back().arm = "random arm 2 of 6";
  }
  verdict.not_checked = {"self-collision", "a \\ b"};
  verdict.assumes = {};
  verdict.notes = {"one note"};
  const test::TemporaryFolder folder;
  const std::string path = folder / "verdict.yaml";
  write_text_file(path, verdict_yaml(verdict));
  const SimulationVerdict read = read_verdict(path);
  ASSERT_EQ(read.checks.size(), verdict.checks.size());
  for (std::size_t i = 0; i < read.checks.size(); ++i) {
    const Check& a = read.checks[i];
    const Check& b = verdict.checks[i];
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.passed, b.passed);
    EXPECT_EQ(a.scenario, b.scenario);
    EXPECT_EQ(a.arm, b.arm);
    EXPECT_EQ(a.joint, b.joint);
    EXPECT_EQ(a.unit, b.unit);
    EXPECT_EQ(a.detail, b.detail);
    for (double Check::*number : {&Check::time, &Check::value, &Check::threshold}) {
      EXPECT_TRUE(a.*number == b.*number || (std::isnan(a.*number) && std::isnan(b.*number)));
    }
  }
  EXPECT_EQ(read.not_checked, verdict.not_checked);
  EXPECT_EQ(read.assumes, verdict.assumes);
  EXPECT_EQ(read.notes, verdict.notes);
  EXPECT_EQ(verdict_yaml(read), verdict_yaml(verdict));
}

TEST(SimulationVerdict, AFileWithACheckOfAnotherVersionIsRefusedWithItsLine) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "verdict.yaml";
  write_text_file(path,
                  "passed: true\nchecks:\n  - {check: telepathy, passed: true}\nnot_checked: []\nassumes: "
                  "[]\nnotes: []\n");
  const std::string refused = test::refusal([&] { read_verdict(path); });
  EXPECT_THAT(refused, HasSubstr(":3:"));
  EXPECT_THAT(refused, HasSubstr("telepathy"));
}

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

TEST(Assumptions, NameTheJointsWithoutRotorsAndThoseThatFrictionStopsWithinAPeriod) {
  Scenario scenario = test::scenario_of("realistic_fixed_target");
  const auto assumed = [&](Stepper stepper = Stepper::kMidpoint) {
    SimulationVerdict verdict;
    add_assumptions({scenario}, stepper, verdict);
    return to_text(verdict);
  };
  EXPECT_THAT(assumed(),
              AllOf(HasSubstr("the rotor inertia that ur10's robot file gives"), Not(HasSubstr("stops"))));
  RobotModel robot = *scenario.robot;
  robot.estimated_rotors = joint_names(robot);
  scenario.robot = std::make_shared<const RobotModel>(robot);
  EXPECT_THAT(assumed(), HasSubstr("the rotor inertia of all joints of ur10 is an estimate"));
  robot.estimated_rotors.clear();
  robot.chain.rotor_inertia[5] = 0.0;
  scenario.robot = std::make_shared<const RobotModel>(robot);
  EXPECT_THAT(assumed(), HasSubstr("no rotor inertia for wrist_3_joint of ur10"));
  robot.chain.rotor_inertia.setZero();
  scenario.robot = std::make_shared<const RobotModel>(robot);
  EXPECT_THAT(assumed(), HasSubstr("ur10 has no rotor inertia"));
  estimate_rotors(robot);
  scenario.robot = std::make_shared<const RobotModel>(robot);
  EXPECT_THAT(assumed(), HasSubstr("the rotor inertia of all joints of ur10 is an estimate"));
  EXPECT_THAT(assumed(), Not(HasSubstr("as it stands")));
  robot.joints[1].limits.effort = 10.0;
  scenario.robot = std::make_shared<const RobotModel>(robot);
  EXPECT_THAT(assumed(), HasSubstr("although it looks wrong: shoulder_lift_joint: it needs"));
  // An explicit step of h is stable up to h c = 2 d; c is Fv + Fc / 0.05 at rest.
  const JointVector d = joint_inertia(plant_model(scenario), scenario.start_position);
  scenario.plant.viscous_friction = JointVector::Constant(6, 0.1);
  scenario.plant.coulomb_friction = JointVector::Zero(6);
  const double bound = (2.0 * d[4] / scenario.control_period - 0.1) * 0.05;
  ASSERT_GT(bound, 0.0);
  scenario.plant.coulomb_friction[4] = 0.99 * bound;
  EXPECT_THAT(assumed(), Not(HasSubstr("friction stops wrist_2_joint")));
  scenario.plant.coulomb_friction[4] = 1.01 * bound;
  EXPECT_THAT(assumed(), HasSubstr("friction stops wrist_2_joint within 0.002 s"));
  EXPECT_THAT(assumed(Stepper::kReference), Not(HasSubstr("friction stops")));
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

TEST(RolloutChecks, LookAtAccelerationsOnlyIfTheArmLimitsThem) {
  ScenarioResult result = result_of("a", {{JointLimit::kAcceleration, "elbow", 7.0, -9.0, -8.0}});
  result.result.metrics[Metric::kJointAccelerationMaxRatio] = 1.125;
  SimulationVerdict verdict;
  add_rollout_checks({result}, "", verdict);
  ASSERT_EQ(verdict.checks.size(), 6U);
  EXPECT_EQ(to_text(verdict.checks[4]), "acceleration limit, elbow, 7.000 s, in a: 9, threshold 8");
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
  EXPECT_EQ(
      to_text(verdict.checks.back()),
      "oscillation, wrist_1_joint, 0.500 s, in early: its torque swings by 1.2 of its effort limit, at 30 "
      "Hz");
}

TEST(RolloutChecks, AScenarioThatDidNotCompleteFailsWithItsReason) {
  ScenarioResult broken = result_of("a", {});
  broken.result.status = RolloutStatus::kDiverged;
  broken.result.reason = "diverged at 1 s";
  SimulationVerdict verdict;
  add_rollout_checks({result_of("b", {}), broken}, "tuned", verdict);
  EXPECT_FALSE(verdict.passed());
  EXPECT_EQ(verdict.checks.front().detail, "diverged at 1 s");
  EXPECT_THAT(verdict.checks.front().scenario, HasSubstr("tuned"));
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

TEST(VerdictThresholds, ALoosenedOneIsNamedAndAStricterOneIsNot) {
  for (const ThresholdField& field : threshold_fields()) {
    VerdictThresholds thresholds;
    EXPECT_TRUE(loosened(thresholds).empty());
    const double usual = thresholds.*field.value;
    thresholds.*field.value = field.larger_is_stricter ? 0.5 * usual : 2.0 * usual;
    const auto sentences = loosened(thresholds);
    ASSERT_EQ(sentences.size(), 1U) << field.name;
    EXPECT_THAT(sentences.front(), HasSubstr(field.name));
    thresholds.*field.value = field.larger_is_stricter ? 2.0 * usual : 0.5 * usual;
    EXPECT_TRUE(loosened(thresholds).empty()) << field.name;
    EXPECT_GE(usual, field.least);
    EXPECT_LE(usual, field.most);
  }
}

TEST(Assumptions, SayWhatOfTheArmMeetsAnObstacle) {
  const auto assumed = [](const Scenario& scenario) {
    SimulationVerdict verdict;
    add_assumptions({scenario}, Stepper::kMidpoint, verdict);
    return verdict.assumes;
  };
  Scenario points = test::scenario_of("obstacle_pass");
  EXPECT_THAT(assumed(points), Not(Contains(HasSubstr("touch an obstacle"))));
  Scenario balls = points;
  for (MovingObstacle& obstacle : balls.obstacles) obstacle.radius = 0.1;
  EXPECT_THAT(assumed(balls),
              Contains(HasSubstr("in obstacle_pass, parts of the arm other than the arm's joint "
                                 "origins and its tool do not touch an obstacle")));
  Scenario links = balls;
  links.robot = std::make_shared<const RobotModel>(with_link_surfaces(*balls.robot));
  EXPECT_THAT(assumed(links), Contains(HasSubstr("other than the capsules between the arm's joints")));
  Scenario shapes = balls;
  Cell cell;
  cell.parts.push_back({"ball", sphere(0.1), Mat3::Identity(), balls.obstacles[0].path, true});
  shapes.clearance = std::make_shared<const ClearanceModel>(balls.robot, cell);
  EXPECT_THAT(assumed(shapes), Not(Contains(HasSubstr("touch an obstacle"))));
}

TEST(Verdict, SaysWhatItAssumesOfTheRobotsOwnController) {
  SimulationVerdict verdict;
  Gains gains;
  const std::vector<Scenario> franka = {test::scenario_of("panda_realistic_moving_target")};
  add_controller_assumption(franka, gains, verdict);
  EXPECT_TRUE(verdict.assumes.empty());
  change_controller(gains, "joint_trajectory_controller", 6);
  add_controller_assumption({test::scenario_of("moving_target")}, gains, verdict);
  EXPECT_THAT(verdict.assumes, ElementsAre(HasSubstr("an empty integral")));
  add_controller_assumption(franka, gains, verdict);
  EXPECT_THAT(verdict.assumes, ElementsAre(HasSubstr("an empty integral"), HasSubstr("compensates gravity")));
  verdict.assumes.clear();
  change_controller(gains, "joint_trajectory_controller_velocity", 6);
  add_controller_assumption({test::scenario_of("moving_target")}, gains, verdict);
  EXPECT_THAT(verdict.assumes,
              ElementsAre(HasSubstr("bandwidth of 60 rad/s"), HasSubstr("an empty integral")));
  verdict.assumes.clear();
  change_controller(gains, "joint_impedance", 7);
  add_controller_assumption(franka, gains, verdict);
  EXPECT_THAT(verdict.assumes, ElementsAre(AllOf(HasSubstr("docs/joint_impedance.md"),
                                                 HasSubstr("does not limit how fast torques change"))));
  verdict.assumes.clear();
  own(gains, "joint_impedance_torque_rate")[0] = 1000.0;
  add_controller_assumption(franka, gains, verdict);
  EXPECT_THAT(verdict.assumes, ElementsAre(testing::Not(HasSubstr("limit"))));
  verdict.assumes.clear();
  change_controller(gains, "cartesian_impedance", 7);
  add_controller_assumption(franka, gains, verdict);
  EXPECT_THAT(verdict.assumes, ElementsAre(AllOf(HasSubstr("docs/cartesian_impedance.md"),
                                                 HasSubstr("does not limit how fast torques change"))));
  verdict.assumes.clear();
  change_controller(gains, "position_streaming", 6);
  own(gains, "servo_position_gain")[0] = 17.5;
  add_controller_assumption({test::scenario_of("moving_target")}, gains, verdict);
  EXPECT_THAT(verdict.assumes,
              ElementsAre(HasSubstr("bandwidth of 60 rad/s"),
                          AllOf(HasSubstr("docs/position_streaming.md"), HasSubstr("17.5"))));
  // Values of the drives that the robot's file gives.
  EXPECT_THAT(verdict.not_checked, testing::Contains(HasSubstr("delays inside the drives")));
  Scenario known = test::scenario_of("moving_target");
  RobotModel robot = *known.robot;
  robot.drive_position_gain = JointVector::Constant(6, 20.0);
  robot.drive_delay = JointVector::Constant(6, 0.001);
  robot.drive_rate = 250.0;
  known.robot = std::make_shared<const RobotModel>(robot);
  own(gains, "servo_position_gain")[0] = 30.0;
  SimulationVerdict of_known;
  add_controller_assumption({known}, gains, of_known);
  EXPECT_THAT(of_known.assumes,
              ElementsAre(HasSubstr("250 Hz"), HasSubstr("2 times the gains that the robot's file gives")));
  EXPECT_THAT(of_known.not_checked, testing::Not(testing::Contains(HasSubstr("delays inside the drives"))));
}

}  // namespace verdict_verdict_test
}  // namespace armtune::internal
