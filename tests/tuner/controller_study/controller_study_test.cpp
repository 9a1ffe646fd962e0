#include "tuner/controller_study/controller_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/control/laws/controller_kind.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/csv/text_file.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/joint_trajectory_example.hpp"
#include "tuner/study/study.hpp"

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
    return test::input_error([&] { write_controller_study(inputs, folder / "none"); });
  };
  EXPECT_THAT(refused({100.0}),
              refused_at({.file = inputs.controllers, .value = "600", .limit = "at most 100"}));
  EXPECT_THAT(refused({1000.0, 1000.0}), refused_at({.value = "2", .limit = "1 or 7"}));
  inputs = example();
  EXPECT_THAT(refused({1000.0}).what(), HasSubstr("has no stiffness"));
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
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "none"); },
              refused_at({.file = folder / "goals.csv", .key = "time"}));
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
  EXPECT_THAT([&] { write_controller_study(example(), folder / "made"); },
              refused_at({.file = folder / "made"}));
  EXPECT_EQ(test::read_text(first.study), own);
}

TEST(ControllerStudy, WritesNothingWhereAFileIsWrong) {
  const test::TemporaryFolder folder;
  const auto refused = [&](const ControllerStudyInputs& inputs) {
    InputError error = test::input_error([&] { write_controller_study(inputs, folder / "new"); });
    EXPECT_FALSE(std::filesystem::exists(folder / "new")) << error.what();
    return error;
  };
  ControllerStudyInputs inputs = example();
  inputs.robot = "ur10e";
  EXPECT_THAT(refused(inputs), refused_at({.value = "ur10e", .suggestion = "ur10"}));
  inputs = example();
  inputs.robot = "panda";
  EXPECT_THAT(
      refused(inputs),
      refused_at({.file = inputs.controllers, .key = "arm_controller", .value = "shoulder_pan_joint"}));
  inputs = example();
  inputs.trajectories = {folder / "none.csv"};
  EXPECT_THAT(refused(inputs), refused_at({.file = folder / "none.csv"}));
  inputs = example();
  const std::string comma = folder / "a,b.csv";
  std::filesystem::copy_file(kExample + "moves.csv", comma);
  inputs.trajectories = {comma};
  EXPECT_THAT(refused(inputs), refused_at({.file = comma}));
  inputs = example();
  inputs.node = "leg_controller";
  EXPECT_THAT(refused(inputs), refused_at({.value = "leg_controller", .limit = "one of: arm_controller"}));
  std::filesystem::create_directory(folder / "full");
  folder.write("full/something.txt", "kept");
  inputs = example();
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "full"); },
              refused_at({.file = folder / "full"}));
}

}  // namespace controller_study_test
}  // namespace armtune::internal
