#include "tuner/verdict/assumptions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/first_gains.hpp"
#include "core/robot/link_radius.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace assumptions_test {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Assumptions, NameTheJointsWithoutRotorsAndThoseThatFrictionStopsWithinAPeriod) {
  Scenario scenario = test::scenario_of("realistic_fixed_target");
  const auto assumed = [&](Stepper stepper = Stepper::kMidpoint) {
    SimulationVerdict verdict;
    add_assumptions({scenario}, stepper, verdict);
    return to_text(verdict);
  };
  RobotModel robot = *scenario.robot;
  robot.rotor_source = ValueSource::kGiven;
  scenario.robot = std::make_shared<const RobotModel>(robot);
  EXPECT_THAT(assumed(),
              AllOf(HasSubstr("the rotor inertia that ur10's robot file gives"), Not(HasSubstr("stops"))));
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

TEST(Assumptions, SayWhereTheRotorInertiaComesFromAndHowFarAnAssumedOneIsFromTheEstimate) {
  Scenario scenario = test::scenario_of("fixed_target");
  RobotModel robot = *scenario.robot;
  estimate_rotors(robot);
  const auto assumed = [&](ValueSource source) {
    robot.rotor_source = source;
    scenario.robot = std::make_shared<const RobotModel>(robot);
    SimulationVerdict verdict;
    add_assumptions({scenario}, Stepper::kMidpoint, verdict);
    return verdict.assumes;
  };
  RobotModel ruled = robot;
  ruled.chain.rotor_inertia.setZero();
  estimate_rotors(ruled);
  robot.chain.rotor_inertia = 0.5 * ruled.chain.rotor_inertia;
  robot.chain.rotor_inertia[0] = 0.125 * ruled.chain.rotor_inertia[0];
  EXPECT_THAT(assumed(ValueSource::kAssumed),
              Contains(AllOf(HasSubstr("nobody measured"), HasSubstr("2 to 8 times as large"))));
  robot.chain.rotor_inertia[5] = 0.0;
  EXPECT_THAT(assumed(ValueSource::kAssumed),
              Contains(AllOf(HasSubstr("no rotor inertia for wrist_3_joint"), HasSubstr("2 to 8 times"))));
  robot.chain.rotor_inertia[5] = 0.1;
  for (const ValueSource source : {ValueSource::kMeasured, ValueSource::kPublished})
    EXPECT_THAT(assumed(source), AllOf(Contains(HasSubstr(name(source) + std::string(" rotor inertia"))),
                                       Not(Contains(HasSubstr("nobody")))));
}

TEST(Assumptions, SayWhereTheJointFrictionOfTheRobotFileComesFrom) {
  Scenario scenario = test::scenario_of("fixed_target");
  RobotModel robot = *scenario.robot;
  const auto assumed = [&] {
    scenario.robot = std::make_shared<const RobotModel>(robot);
    SimulationVerdict verdict;
    add_assumptions({scenario}, Stepper::kMidpoint, verdict);
    return verdict.assumes;
  };
  EXPECT_THAT(assumed(),
              AllOf(Contains(HasSubstr("no joint friction")), Not(Contains(HasSubstr("Coulomb")))));
  robot.chain.coulomb_friction.setConstant(0.1);
  EXPECT_THAT(assumed(), Contains("the Coulomb friction that ur10's robot file gives"));
  robot.coulomb_source = ValueSource::kEstimated;
  robot.chain.viscous_friction[2] = 0.1;
  for (const ValueSource source : {ValueSource::kMeasured, ValueSource::kPublished, ValueSource::kAssumed}) {
    robot.viscous_source = source;
    EXPECT_THAT(assumed(), AllOf(Contains(AllOf(HasSubstr(name(source) + std::string(" viscous friction")),
                                                HasSubstr("estimated Coulomb friction"), HasSubstr("ur10"))),
                                 Not(Contains(HasSubstr("no joint friction")))));
  }
}

TEST(Assumptions, NameTheLinksWithDrawnShapesOnly) {
  Scenario scenario = test::scenario_of("fixed_target");
  const auto assumed = [&](const char* name) {
    scenario.robot = load_robot(name);
    scenario.clearance = std::make_shared<const ClearanceModel>(scenario.robot, Cell{});
    SimulationVerdict verdict;
    add_assumptions({scenario}, Stepper::kMidpoint, verdict);
    return verdict.assumes;
  };
  scenario.start_position = JointVector::Zero(5);
  EXPECT_THAT(assumed("youbot"),
              Contains(AllOf(HasSubstr("drawn shapes"), HasSubstr("arm_link_1"), HasSubstr("youbot"))));
  scenario.start_position = JointVector::Zero(6);
  EXPECT_THAT(assumed("ur10"), Not(Contains(HasSubstr("drawn shapes"))));
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
  EXPECT_THAT(verdict.assumes, ElementsAre(Not(HasSubstr("limit"))));
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
  EXPECT_THAT(verdict.not_checked, Contains(HasSubstr("delays inside the drives")));
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
  EXPECT_THAT(of_known.not_checked, Not(Contains(HasSubstr("delays inside the drives"))));
}

}  // namespace assumptions_test
}  // namespace armtune::internal
