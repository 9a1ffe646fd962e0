#include "tuner/controller_study/controller_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <tuple>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/first_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/joint_trajectory_example.hpp"
#include "tuner/controller_study/controller_rate.hpp"
#include "tuner/session/study_files.hpp"
#include "tuner/session/tune_files.hpp"
#include "tuner/study/study.hpp"
#include "tuner/verdict/assumptions.hpp"

namespace armtune::internal {
namespace controller_study_test {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

using test::example;
using test::kExample;
using test::refused_at;

/// The example's parameters with one text in place of another.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = test::read_text(kExample + "ros2_controllers.yaml");
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// A p of 5 and the whole desired velocity for each joint of the UR5e.
std::string velocity_gains() {
  std::string text;
  for (const std::string& joint : joint_names(*load_robot("ur5e")))
    text += "      " + joint + ": {p: 5.0, i: 0.0, d: 0.0, ff_velocity_scale: 1.0}\n";
  return text;
}

TEST(ControllerStudy, LoadsWithTheFilesGainsItsRateAndEveryMotion) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  // Motions of one name, and one that is called as a file that is written.
  inputs.trajectories.push_back(inputs.trajectories.front());
  std::filesystem::copy_file(kExample + "moves.csv", folder / "study.csv");
  inputs.trajectories.push_back(folder / "study.csv");
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.written,
              UnorderedElementsAre("study.yaml", "moves.yaml", "moves_2.yaml", "study_2.yaml"));
  const Study study = load_study(files.study);
  ASSERT_EQ(study.scenarios.size(), 3U);
  const Scenario& scenario = study.scenarios.front();
  EXPECT_EQ(scenario.name, "moves");
  EXPECT_EQ(scenario.control_period, 0.002);
  EXPECT_FALSE(scenario.has_task());
  // Positions alone are joined by straight lines, as ROS does, and that is said.
  EXPECT_FALSE(scenario.planned->at(0.5).velocity.isZero(0.0));
  EXPECT_TRUE(scenario.planned->at(0.5).acceleration.isZero(1e-12));
  EXPECT_EQ(study.space.start.controller, "joint_trajectory_controller");
  EXPECT_EQ(study.space.free.size(), 18U);
  EXPECT_TRUE(scenario.clearance->has(Clearance::kSelf));
  EXPECT_THAT(study.constraints, Contains(testing::Field(&Constraint::metric, Metric::kClearanceSelf)));
  EXPECT_FALSE(study.margins.empty());
  EXPECT_TRUE(study.robust);
  EXPECT_THAT(files.notes, Contains(HasSubstr("straight lines")));
}

TEST(ControllerStudy, EstimatesTheRotorsThatNobodyGives) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.robot = test::source_dir() + "/examples/ur5e/ur5e.urdf";
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.written, Contains("robot.yaml"));
  EXPECT_THAT(files.notes, Contains(HasSubstr("rotor inertia")));
  EXPECT_EQ(load_study(files.study).scenarios[0].robot->estimated_rotors.size(), 6U);
}

// How stiff an arm may become in a contact is the user's to say.
TEST(ControllerStudy, TunesTheStiffnessOfAnImpedanceControllerUpToTheGivenBoundAlone) {
  const test::TemporaryFolder folder;
  const std::string files_of = test::source_dir() + "/examples/joint_impedance/";
  ControllerStudyInputs inputs{"panda", files_of + "controllers.yaml", "", {files_of + "moves.csv"}};
  const ControllerStudyFiles damping = write_controller_study(inputs, folder / "damping").value();
  EXPECT_THAT(damping.notes, ElementsAre(HasSubstr("1000 Hz"), HasSubstr("--max-stiffness")));
  const Study without = load_study(damping.study);
  ASSERT_EQ(without.space.free.size(), 7U) << "the damping alone";
  EXPECT_EQ(without.space.free.front().entry.name, "joint_impedance_d/panda_joint1");

  inputs.max_stiffness = {1000.0};
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.notes, ElementsAre(HasSubstr("1000 Hz")));
  const Study study = load_study(files.study);
  EXPECT_EQ(study.scenarios.front().control_period, 0.001);
  EXPECT_EQ(study.space.start.controller, "joint_impedance");
  EXPECT_EQ(own(study.space.start, "joint_impedance_velocity_factor")[0], 0.0);
  ASSERT_EQ(study.space.free.size(), 14U);
  EXPECT_EQ(study.space.free.front().entry.name, "joint_impedance_k/panda_joint1");
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_EQ(study.space.free[k].upper, 1000.0);
    EXPECT_DOUBLE_EQ(study.space.free[k].lower, 0.2 * study.space.free[k].start);
  }
  inputs.max_stiffness = {1000.0, 1000.0, 1000.0, 1000.0, 500.0, 500.0, 90.0};
  const Study each = load_study(write_controller_study(inputs, folder / "each").value().study);
  EXPECT_EQ(each.space.free[6].upper, 90.0);

  const auto refused = [&](const std::vector<double>& most) {
    inputs.max_stiffness = most;
    return test::refusal([&] { write_controller_study(inputs, folder / "none"); });
  };
  EXPECT_THAT(refused({100.0}), AllOf(HasSubstr("controllers.yaml"), HasSubstr("above --max-stiffness 100")));
  EXPECT_THAT(refused({1000.0, 1000.0}), HasSubstr("one for all joints, or 7"));
  inputs = example();
  EXPECT_THAT(refused({1000.0}), HasSubstr("has no stiffness"));
  // Without a file the start follows from the arm, and stays within the bound.
  inputs.controllers.clear();
  inputs.kind = "joint_impedance";
  inputs.rate = 1000.0;
  inputs.max_stiffness = {30.0};
  const Study own_start = load_study(write_controller_study(inputs, folder / "own").value().study);
  for (const double k : own(own_start.space.start, "joint_impedance_k")) EXPECT_LE(k, 30.0);
}

TEST(ControllerStudy, SaysNothingOfAMotionWithVelocities) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.trajectories = {folder.write(
      "moves.yaml",
      "joint_names: [shoulder_pan_joint, shoulder_lift_joint, elbow_joint, wrist_1_joint, wrist_2_joint, "
      "wrist_3_joint]\npoints:\n"
      "- {positions: [0, -1.5, 1, 0, 0, 0], velocities: [0, 0, 0, 0, 0, 0], time_from_start: 0}\n"
      "- {positions: [1, -1.5, 1, 0, 0, 0], velocities: [0, 0, 0, 0, 0, 0], time_from_start: 2}\n")};
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.notes, ElementsAre(HasSubstr("500 Hz"), HasSubstr("ROS 2 Jazzy")));
  EXPECT_EQ(load_study(files.study).scenarios[0].planned->at(1.0).position[0], 0.5);
}

TEST(ControllerStudy, PlansTheMotionThroughGoalsWithoutTimes) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  const std::string goals =
      "shoulder_pan_joint,shoulder_lift_joint,elbow_joint,wrist_1_joint,wrist_2_joint,wrist_3_joint\n"
      "0,-90,60,-60,-90,0\n30,-70,60,-60,-90,0\n";
  inputs.trajectories = {folder.write("goals.csv", goals)};
  inputs.degrees = true;
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder / "none"); }), HasSubstr("'time'"));
  JointGoals asked;
  inputs.timing = [&asked](const JointGoals& given) {
    asked = given;
    const JointVector zero = JointVector::Zero(6);
    return TimedGoals{
        {{0.0, 2.0}, {{given.positions[0], zero, zero}, {given.positions[1], zero, zero}}},
        "joint_names: [shoulder_pan_joint, shoulder_lift_joint, elbow_joint, wrist_1_joint, wrist_2_joint, "
        "wrist_3_joint]\npoints:\n- {positions: [0, -1.5, 1, 0, 0, 0], time_from_start: 0}\n"
        "- {positions: [1, -1.5, 1, 0, 0, 0], time_from_start: 3}\n"};
  };
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  ASSERT_EQ(asked.positions.size(), 2U);
  EXPECT_DOUBLE_EQ(asked.positions[1][0], std::numbers::pi / 6.0);
  EXPECT_EQ(asked.robot->name, "ur5e");
  EXPECT_TRUE(asked.clearance->has(Clearance::kSelf));
  EXPECT_TRUE(asked.ros2);
  EXPECT_THAT(files.written, UnorderedElementsAre("study.yaml", "goals.yaml", "goals_motion.yaml"));
  EXPECT_THAT(files.notes, Contains(AllOf(HasSubstr("takes 2.0 s"), HasSubstr("goals_motion.yaml"))));
  const Scenario scenario = load_study(files.study).scenarios.front();
  EXPECT_EQ(scenario.planned->end(), 3.0) << "the scenario follows the message";

  inputs.timing = [](const JointGoals&) { return std::nullopt; };
  EXPECT_FALSE(write_controller_study(inputs, folder / "stopped")) << "stopped while it was planned";
  EXPECT_FALSE(std::filesystem::exists(folder / "stopped"));
}

TEST(ControllerStudy, TakesTheRateThatIsGivenOverTheFiles) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.rate = 250.0;
  const ControllerStudyFiles given = write_controller_study(inputs, folder / "a").value();
  EXPECT_EQ(load_study(given.study).scenarios[0].control_period, 0.004);
  EXPECT_THAT(given.notes, testing::Not(Contains(HasSubstr("control rate")))) << "no other rate counts";
  inputs.rate = 0.0;
  inputs.controllers = folder.write("none.yaml", changed("update_rate: 500", "use_sim_time: false"));
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder / "b"); }),
              AllOf(HasSubstr("none.yaml"), HasSubstr("--rate HZ")));
}

/// The rate that is read of a file.
ControllerRate rate_in(const std::string& text) {
  return controller_rate(chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml"), "f.yaml")
      .value_or(ControllerRate{std::numeric_limits<double>::quiet_NaN(), "none"});
}

/// The rate that is read of the example's parameters with one text in place of another; NaN: none.
double rate_of(const std::string& from, const std::string& to) {
  return rate_in(changed(from, to)).hertz;
}

TEST(ControllerRate, IsTheControllersOwnThenThatOfItsManagerAndOfNoOtherNode) {
  EXPECT_EQ(rate_of("update_rate: 500", "update_rate: 400"), 400.0);
  const std::string effort = "command_interfaces: [effort]";
  EXPECT_EQ(rate_of(effort, effort + "\n    update_rate: 100"), 100.0);
  EXPECT_EQ(rate_of(effort, effort + "\n    update_rate: 0"), 500.0) << "0 stands for the manager's";
  // Another node with a rate of its own, before the manager and in its place.
  const std::string other = "state_broadcaster:\n  ros__parameters:\n    update_rate: 50\n";
  EXPECT_EQ(rate_of("controller_manager:", other + "controller_manager:"), 500.0);
  EXPECT_TRUE(std::isnan(rate_of("controller_manager:", "state_broadcaster:")));
  EXPECT_EQ(rate_of("controller_manager:", "/left/controller_manager:"), 500.0);
  EXPECT_EQ(rate_of("controller_manager:", "\"/**\":"), 500.0);
  for (const char* wrong : {"5", "0", "-1", "fast", "1e9"})
    EXPECT_THAT([&] { rate_of("update_rate: 500", std::string("update_rate: ") + wrong); },
                refused_at({.file = "f.yaml",
                            .line = 3,
                            .key = "controller_manager/update_rate",
                            .value = wrong,
                            .limit = "10 to 10000 Hz"}));
}

// As in the driver of Universal Robots for ROS 1, and in the template of ros_control_boilerplate.
TEST(ControllerRate, OfRos1IsThatOfTheControlLoop) {
  const std::string arm =
      "arm:\n  type: effort_controllers/JointTrajectoryController\n  gains: {j1: {p: 1.0}}\n";
  const auto found = [&arm](const std::string& more) { return rate_in(arm + more); };
  EXPECT_EQ(found("hardware_control_loop:\n   loop_hz: &loop_hz 125\n").hertz, 125.0);
  EXPECT_EQ(found("hardware_control_loop: {loop_hz: 125}\n").key, "hardware_control_loop/loop_hz");
  EXPECT_EQ(found("left: {generic_hw_control_loop: {loop_hz: 300}}\n").hertz, 300.0);
  EXPECT_EQ(found("hardware_interface: {loop_hz: 300, joints: [j1]}\n").hertz, 300.0);
  EXPECT_TRUE(std::isnan(found("joint_state_controller: {publish_rate: 50, loop_hz: 50}\n").hertz));
  EXPECT_EQ(found("controller_manager: {update_rate: 250}\nhardware_control_loop: {loop_hz: 125}\n").hertz,
            250.0);
  EXPECT_THAT([&] { found("hardware_control_loop: {loop_hz: 2}\n"); },
              refused_at({.line = 4, .key = "hardware_control_loop/loop_hz", .value = "2"}));
}

TEST(ControllerStudy, SaysWhichRateItReadAndWhichControllerItChose) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write(
      "more.yaml",
      changed("update_rate: 500\n",
              "update_rate: 500\n    joint_state_broadcaster: {type: "
              "joint_state_broadcaster/JointStateBroadcaster}\n") +
          "gripper:\n  ros__parameters:\n    command_interfaces: [effort]\n    gains: {finger: {p: 9.0}}\n");
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "a").value();
  EXPECT_THAT(files.notes, Contains(AllOf(HasSubstr("500 Hz"), HasSubstr("controller_manager/update_rate"))));
  EXPECT_THAT(files.notes, Contains(AllOf(HasSubstr("arm_controller is tuned"), HasSubstr("gripper"),
                                          HasSubstr("joint_state_broadcaster"))));
  const Study study = load_study(files.study);
  EXPECT_EQ(own(study.space.start, "jtc_p")[0], 2000.0);
  // The same controller gets the tuned gains.
  Gains tuned = study.space.start;
  own(tuned, "jtc_p")[0] = 1234.5;
  std::filesystem::create_directory(folder / "run");
  EXPECT_EQ(write_controllers(study, tuned, folder / "run"), "more.yaml");
  std::string expected = test::read_text(inputs.controllers);
  expected.replace(expected.find("p: 2000.0"), 9, "p: 1234.5");
  EXPECT_EQ(test::read_text(folder / "run/more.yaml"), expected);
}

// The desired positions of such a controller are those of the points alone.
TEST(ControllerStudy, OfAControllerThatDoesNotInterpolateJumpsFromPointToPoint) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write(
      "none.yaml", changed("    gains:   # set by hand", "    interpolation_method: none\n    gains:"));
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "none"); },
              refused_at({.file = HasSubstr("moves.csv"), .key = "velocities"}))
      << "ROS reads a velocity of each point";
  inputs.trajectories = {folder.write(
      "steps.yaml",
      "joint_names: [shoulder_pan_joint, shoulder_lift_joint, elbow_joint, wrist_1_joint, wrist_2_joint, "
      "wrist_3_joint]\npoints:\n"
      "- {positions: [0, -1.5, 1, 0, 0, 0], velocities: [0, 0, 0, 0, 0, 0], time_from_start: 0}\n"
      "- {positions: [0.01, -1.5, 1, 0, 0, 0], velocities: [0, 0, 0, 0, 0, 0], time_from_start: 0.5}\n"
      "- {positions: [0.02, -1.5, 1, 0, 0, 0], velocities: [0, 0, 0, 0, 0, 0], time_from_start: 1}\n")};
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.notes, Contains(HasSubstr("interpolation_method: none")));
  const Study study = load_study(files.study);
  const Scenario& scenario = study.scenarios.front();
  EXPECT_EQ(scenario.start_position[0], 0.0);
  EXPECT_EQ(scenario.planned->at(0.25).position[0], 0.01);
  EXPECT_EQ(scenario.planned->at(0.75).position[0], 0.02);
  const RolloutResult result = Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(study.space.start);
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_GE(result.metrics[Metric::kJointErrorMax], 0.0099) << "the step of the desired position";
}

// Industrial arms: the drives have the damping.
TEST(ControllerStudy, OfVelocityCommandsIsOfThatKind) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write("v.yaml",
                                    "controller_manager: {ros__parameters: {update_rate: 500}}\n"
                                    "arm_controller:\n  ros__parameters:\n"
                                    "    type: joint_trajectory_controller/JointTrajectoryController\n"
                                    "    command_interfaces: [velocity]\n    gains:\n" +
                                        velocity_gains());
  const Study study = load_study(write_controller_study(inputs, folder / "a").value().study);
  EXPECT_EQ(study.space.start.controller, "joint_trajectory_controller_velocity");
  EXPECT_EQ(study.space.free.size(), 6U) << "p alone";
  const RolloutResult result =
      Rollout(study.scenarios.front(), Stepper::kMidpoint, Engine::kNative).run(study.space.start);
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_LT(result.metrics[Metric::kJointErrorMax], 0.05);
  const RolloutResult judged =
      Rollout(study.scenarios.front(), Stepper::kMidpoint, Engine::kSimbody).run(study.space.start);
  for (const Metric metric : {Metric::kJointErrorMax, Metric::kJointErrorRms, Metric::kJointEffortMaxRatio})
    EXPECT_NEAR(result.metrics[metric], judged.metrics[metric], 1e-9) << name(metric);
}

// As in files that were made for a simulator: without any damping a stiff joint shakes.
TEST(ControllerStudy, DampingThatIsZeroIsTunedWhereTheFileHasANumberForIt) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers =
      folder.write("p.yaml", changed("wrist_1_joint: {p: 300.0, d: 10.0", "wrist_1_joint: {p: 300.0, d: 0"));
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "a").value();
  EXPECT_THAT(files.notes, Contains(AllOf(HasSubstr("d of wrist_1_joint is 0"), HasSubstr("p.yaml"))));
  const Study study = load_study(files.study);
  EXPECT_EQ(study.space.free.size(), 18U);
  const auto damping = std::find_if(study.space.free.begin(), study.space.free.end(),
                                    [](const Parameter& p) { return p.entry.name == "jtc_d/wrist_1_joint"; });
  ASSERT_NE(damping, study.space.free.end());
  EXPECT_EQ(damping->start, 0.0);
  EXPECT_EQ(damping->lower, 0.0);
  // Five times what is critically damped at the rate of first gains.
  const Scenario& scenario = study.scenarios.front();
  const JointVector inertia = joint_inertia(*scenario.robot, scenario.planned->at(0.0).position);
  EXPECT_NEAR(damping->upper, 5.0 * kFirstRate * inertia[3], 1e-3 * damping->upper);
  // A file without the number could not be given one.
  inputs.controllers =
      folder.write("none.yaml", changed("wrist_1_joint: {p: 300.0, d: 10.0,", "wrist_1_joint: {p: 300.0,"));
  EXPECT_EQ(load_study(write_controller_study(inputs, folder / "b").value().study).space.free.size(), 17U);
}

// Of a PD controller, and of one whose wrists have no integral: what is 0 stays 0.
TEST(ControllerStudy, GainsThatAreZeroAreNotTuned) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers =
      folder.write("pd.yaml", changed("p: 300.0, d: 10.0, i: 50.0", "p: 300.0, d: 10.0, i: 0.0"));
  const Study study = load_study(write_controller_study(inputs, folder / "a").value().study);
  EXPECT_EQ(study.space.free.size(), 17U);
  EXPECT_EQ(study.space.start.own[1][3], 0.0);
}

/// The file of an arm whose second joint has the p of the first through an alias, and one more alias.
std::string shared_numbers_of_shoulder(const std::string& more) {
  std::string text = changed("shoulder_pan_joint: {p: 2000.0", "shoulder_pan_joint: {p: &stiff 2000.0");
  text.replace(text.find("p: 2000.0"), 9, "p: *stiff");
  return text + more;
}

// One number of the text gets one value: the study links the gains of both joints.
TEST(ControllerStudy, LinksGainsThatAreOneNumberOfTheFile) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write("shared.yaml", shared_numbers_of_shoulder(""));
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.notes, Contains(AllOf(HasSubstr("shared.yaml"), HasSubstr("alias"),
                                          HasSubstr("p of shoulder_pan_joint, shoulder_lift_joint"))));
  const Study study = load_study(files.study);
  EXPECT_EQ(study.space.free.size(), 17U);
  ASSERT_EQ(study.space.links.size(), 1U);
  const Link& link = study.space.links.front();
  EXPECT_EQ(link.entry.name, "jtc_p/shoulder_lift_joint");
  EXPECT_EQ(study.space.free[link.parameter].entry.name, "jtc_p/shoulder_pan_joint");
  EXPECT_EQ(link.factor, 1.0);
  // Any point of the search can be written.
  const Gains tuned = study.space.gains_at(std::vector<double>(17, 0.7));
  EXPECT_EQ(own(tuned, "jtc_p")[1], own(tuned, "jtc_p")[0]);
  std::filesystem::create_directory(folder / "run");
  EXPECT_EQ(write_controllers(study, tuned, folder / "run"), "shared.yaml");
  EXPECT_THAT(test::read_text(folder / "run/shared.yaml"), HasSubstr("p: *stiff"));
}

TEST(ControllerStudy, AFileThatCannotHoldOtherGainsIsRefusedBeforeASearch) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write("shared.yaml", shared_numbers_of_shoulder("other: {x: {y: *stiff}}\n"));
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "new"); },
              refused_at({.file = inputs.controllers, .line = testing::Gt(0), .key = "arm_controller"}));
}

TEST(ControllerStudy, ConstrainsWhatTheArmCanTouch) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.robot = folder.write(
      "arm.yaml", "urdf: " + test::source_dir() +
                      "/sim/robots/ur5e.urdf\ntip_link: tool0\nrotor_inertia: estimated\n"
                      "cell: {floor: -0.5, parts: [{name: wall, box: [0.1, 2, 2], center: [-2, 0, 0]}]}\n");
  const Study study = load_study(write_controller_study(inputs, folder / "made").value().study);
  for (const Metric metric : {Metric::kClearanceSelf, Metric::kClearanceCell, Metric::kClearanceFloor,
                              Metric::kJointPositionMinMargin})
    EXPECT_THAT(study.constraints, Contains(testing::Field(&Constraint::metric, metric))) << name(metric);
}

TEST(ControllerStudy, TheSameCallAgainLeavesWhatIsThereAndAChangedStudyIsNotOverwritten) {
  const test::TemporaryFolder folder;
  const ControllerStudyFiles first = write_controller_study(example(), folder / "made").value();
  EXPECT_EQ(write_controller_study(example(), folder / "made").value().study, first.study);
  const std::string own = test::read_text(first.study) + "# mine\n";
  folder.write("made/study.yaml", own);
  EXPECT_THAT(test::refusal([&] { write_controller_study(example(), folder / "made"); }), HasSubstr("made"));
  EXPECT_EQ(test::read_text(first.study), own);
}

TEST(ControllerStudy, WritesNothingWhereAFileIsWrong) {
  const test::TemporaryFolder folder;
  const auto refused = [&](const ControllerStudyInputs& inputs) {
    std::string why = test::refusal([&] { write_controller_study(inputs, folder / "new"); });
    EXPECT_FALSE(std::filesystem::exists(folder / "new")) << why;
    return why;
  };
  ControllerStudyInputs inputs = example();
  inputs.robot = "ur10e";
  EXPECT_THAT(refused(inputs), HasSubstr("ur10e"));
  inputs = example();
  inputs.robot = "panda";
  EXPECT_THAT(refused(inputs), HasSubstr("ros2_controllers.yaml"));
  inputs = example();
  inputs.trajectories = {folder / "none.csv"};
  EXPECT_THAT(refused(inputs), HasSubstr("none.csv"));
  inputs = example();
  const std::string comma = folder / "a,b.csv";
  std::filesystem::copy_file(kExample + "moves.csv", comma);
  inputs.trajectories = {comma};
  EXPECT_THAT(refused(inputs), HasSubstr("a,b"));
  inputs = example();
  inputs.node = "leg_controller";
  EXPECT_THAT(refused(inputs), AllOf(HasSubstr("leg_controller"), HasSubstr("arm_controller")));
  std::filesystem::create_directory(folder / "full");
  folder.write("full/something.txt", "kept");
  inputs = example();
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder / "full"); }), HasSubstr("full"));
}

TEST(ControllerStudy, FollowsTheDistributionThatIsNamedAndSaysSo) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  for (const auto& [name, title, number] :
       {std::tuple{"", "ROS 2 Jazzy", 0.0}, {"jazzy", "ROS 2 Jazzy", 0.0}, {"humble", "ROS 2 Humble", 1.0}}) {
    inputs.distro = name;
    const ControllerStudyFiles files =
        write_controller_study(inputs, folder / (std::string("study_") + name)).value();
    EXPECT_THAT(files.notes, Contains(AllOf(HasSubstr("arm_controller"), HasSubstr(title))));
    const Study study = load_study(files.study);
    EXPECT_EQ(study.distro, distro_from_name(name));
    EXPECT_EQ(own(study.space.start, "jtc_distro")[0], number);
    SimulationVerdict verdict;
    add_controller_assumption(study.scenarios, study.space.start, verdict);
    EXPECT_THAT(verdict.assumes, Contains(HasSubstr(title)));
    // Tuned gains go back into the file by the same rules.
    std::filesystem::create_directory(folder / (std::string("run_") + name));
    EXPECT_EQ(write_controllers(study, study.space.start, folder / (std::string("run_") + name)),
              "ros2_controllers.yaml");
  }
  inputs.distro = "noetic";
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder / "none"); }),
              HasSubstr("ROS 1 Noetic"));
  std::string text = test::read_text(folder / "study_humble/study.yaml");
  text.replace(text.find("distro: humble"), 14, "distro: rolling");
  const std::string rolling = folder.write("study_humble/rolling.yaml", text);
  EXPECT_THAT(test::refusal([&] { load_study(rolling); }),
              AllOf(HasSubstr("rolling.yaml:"), HasSubstr("jazzy, humble")));
}

TEST(ControllerStudy, TakesTheControllerThatIsNamedOfSeveral) {
  const test::TemporaryFolder folder;
  std::string text = test::read_text(kExample + "ros2_controllers.yaml");
  std::string second = text.substr(text.find("arm_controller:\n"));
  second.replace(0, 3, "leg");
  second.replace(second.find("p: 2000.0"), 9, "p: 1500.0");
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write("two.yaml", text + second);
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder / "a"); }),
              HasSubstr("name one of them"));
  inputs.node = "leg_controller";
  const Study study = load_study(write_controller_study(inputs, folder / "a").value().study);
  EXPECT_EQ(study.space.start.own[0][0], 1500.0);
  // And it is that one whose numbers change.
  Gains tuned = study.space.start;
  tuned.own[0][0] = 1234.5;
  std::filesystem::create_directory(folder / "run");
  EXPECT_EQ(write_controllers(study, tuned, folder / "run"), "two.yaml");
  std::string expected = text + second;
  expected.replace(expected.find("p: 1500.0"), 9, "p: 1234.5");
  EXPECT_EQ(test::read_text(folder / "run/two.yaml"), expected);
}

TEST(ControllerStudy, AParameterFileThatIsCalledAsOneOfTheRunsGetsAnotherName) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write("gains.yaml", test::read_text(kExample + "ros2_controllers.yaml"));
  const Study study = load_study(write_controller_study(inputs, folder / "a").value().study);
  std::filesystem::create_directory(folder / "run");
  EXPECT_EQ(write_controllers(study, study.space.start, folder / "run"), "ros_gains.yaml");
  EXPECT_EQ(test::read_text(folder / "run/ros_gains.yaml"), test::read_text(inputs.controllers))
      << "gains that are the file's change nothing";
}

TEST(ControllerStudy, OtherStudiesHaveNoParameterFileToChange) {
  const test::TemporaryFolder folder;
  const Study study = load_study("ur10_gaze");
  EXPECT_EQ(write_controllers(study, study.space.start, folder / "."), "");
}

}  // namespace controller_study_test
}  // namespace armtune::internal
