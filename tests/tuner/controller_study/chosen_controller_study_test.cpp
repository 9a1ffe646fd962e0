// Which controller of a file a study tunes, by which distribution and rate, and where tuned gains go.

#include "tuner/controller_study/controller_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <tuple>

#include "core/control/laws/controller_kind.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/joint_trajectory_example.hpp"
#include "tuner/session/study_files.hpp"
#include "tuner/session/tune_files.hpp"
#include "tuner/study/study.hpp"
#include "tuner/verdict/assumptions.hpp"

namespace armtune::internal {
namespace chosen_controller_study_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

using test::changed_example;
using test::example;
using test::kExample;
using test::refused_at;

TEST(ControllerStudy, TakesTheRateThatIsGivenOverTheFiles) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.rate = 250.0;
  const ControllerStudyFiles given = write_controller_study(inputs, folder / "a").value();
  EXPECT_EQ(load_study(given.study).scenarios[0].control_period, 0.004);
  EXPECT_THAT(given.notes, testing::Not(Contains(HasSubstr("control rate")))) << "no other rate counts";
  inputs.rate = 0.0;
  inputs.controllers = folder.write("none.yaml", changed_example("update_rate: 500", "use_sim_time: false"));
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "b"); },
              refused_at({.file = folder / "none.yaml", .key = "update_rate"}));
}

TEST(ControllerStudy, SaysWhichRateItReadAndWhichControllerItChose) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write(
      "more.yaml",
      changed_example("update_rate: 500\n",
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
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "none"); },
              refused_at({.file = inputs.controllers}));
  std::string text = test::read_text(folder / "study_humble/study.yaml");
  text.replace(text.find("distro: humble"), 14, "distro: rolling");
  const std::string rolling = folder.write("study_humble/rolling.yaml", text);
  EXPECT_THAT(
      [&] { load_study(rolling); },
      refused_at({.file = rolling, .key = "distro", .value = "rolling", .limit = "jazzy, humble or noetic"}));
}

TEST(ControllerStudy, TakesTheControllerThatIsNamedOfSeveral) {
  const test::TemporaryFolder folder;
  std::string text = test::read_text(kExample + "ros2_controllers.yaml");
  std::string second = text.substr(text.find("arm_controller:\n"));
  second.replace(0, 3, "leg");
  second.replace(second.find("p: 2000.0"), 9, "p: 1500.0");
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write("two.yaml", text + second);
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "a"); },
              refused_at({.value = "2", .limit = "one of: arm_controller, leg_controller"}));
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

}  // namespace chosen_controller_study_test
}  // namespace armtune::internal
