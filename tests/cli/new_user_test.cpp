// The way of a new user: the URDF of an arm that nobody here has seen, and four commands.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/robot/urdf_writer.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace new_user_test {

using test::Finished;
using test::run_program;
using testing::HasSubstr;

/// `text` with `value` behind `key`.
std::string filled(std::string text, const std::string& key, const std::string& value) {
  const auto at = text.find(key);
  EXPECT_NE(at, std::string::npos) << key;
  return at == std::string::npos ? text : text.insert(at + key.size(), value);
}

TEST(NewUser, TunesAnUnknownArmInFourCommands) {
  const test::TemporaryFolder folder;
  // As URDFs come: without one joint's velocity limit, and nothing about rotors.
  std::string urdf = urdf_text(test::random_arm(6, 12, false));
  const auto velocity = urdf.find("velocity=\"");
  ASSERT_NE(velocity, std::string::npos);
  urdf.erase(velocity, urdf.find('"', velocity + 10) + 1 - velocity);
  const auto name = urdf.find("random_arm_6");
  ASSERT_NE(name, std::string::npos);
  urdf.replace(name, 12, "arm: v2");
  const std::string path = folder.write("unknown.urdf", urdf);
  const std::string robot = folder / "unknown.yaml";
  const std::string task = folder / "task";
  const std::string run = folder / "run";

  const Finished first = run_program({"robot", path, "--sidecar", robot});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("velocity limit of"));
  folder.write("unknown.yaml", filled(test::read_text(robot), "velocity:", " 2.5") +
                                   "tip_link: tool\nrotor_inertia: [0.2, 0.2, 0.2, 0.1, 0.1, 0.1]\n");

  const Finished second = run_program({"robot", robot, "--task", task});
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_THAT(second.out, HasSubstr("next: armtune tune " + task + "/study.yaml"));

  const Finished third =
      run_program({"tune", task + "/study.yaml", "--out", run, "--max-evaluations", "25", "--no-analysis"});
  ASSERT_EQ(third.exit_code, 0) << third.err << third.out;

  const Finished fourth = run_program({"report", run});
  ASSERT_EQ(fourth.exit_code, 0) << fourth.err;
  for (const char* file : {"/gains.yaml", "/errors.csv", "/evaluations.csv", "/report.html"}) {
    EXPECT_TRUE(std::filesystem::exists(run + file)) << file;
  }
}

TEST(NewUser, SeesWhichRobotsAreBundled) {
  const Finished done = run_program({"robot"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  for (const char* name :
       {"ur10", "ur3e", "ur5e", "panda", "fr3", "xarm6", "xarm7", "gen3_6", "gen3_7", "iiwa14", "youbot"})
    EXPECT_THAT(done.out, HasSubstr(std::string(name) + " "));
  EXPECT_EQ(run_program({"robot", "--task", "nowhere"}).exit_code, 2);
}

// A URDF without rotor inertia: it is estimated, and every page that rests on it says so.
TEST(NewUser, AnArmWithoutRotorsGetsATaskThatItCompletesAndTheVerdictSaysWhatWasEstimated) {
  const test::TemporaryFolder folder;
  RobotModel arm = test::ur10();
  arm.chain.rotor_inertia.setZero();
  const std::string urdf = folder.write("arm.urdf", urdf_text(arm));
  const std::string task = folder / "task";
  const Finished made = run_program({"robot", urdf, "--task", task});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out,
              testing::AllOf(HasSubstr("No rotor inertia is given"), HasSubstr("completes the task")));
  const Finished simulated = run_program({"simulate", task + "/task.yaml", "--gains", task + "/gains.yaml"});
  EXPECT_EQ(simulated.exit_code, 0) << simulated.out << simulated.err;
  EXPECT_THAT(simulated.out, HasSubstr("is an estimate"));
}

TEST(NewUser, IsWarnedOfFiguresThatAreNoArms) {
  const test::TemporaryFolder folder;
  RobotModel arm = test::ur10();
  arm.joints[1].limits.effort = 10.0;
  arm.joints[0].limits.velocity = 120.0;
  const Finished shown = run_program({"robot", folder.write("arm.urdf", urdf_text(arm))});
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_THAT(shown.err, testing::AllOf(HasSubstr("shoulder_pan_joint (120)"),
                                        HasSubstr("shoulder_lift_joint: it needs")));
}

TEST(NewUser, SeesTheDrivesThatTheRobotFileGives) {
  const test::TemporaryFolder folder;
  folder.write("arm.urdf", urdf_text(test::ur10()));
  const auto shown = [&folder](const std::string& drives) {
    return run_program({"robot", folder.write("arm.yaml", "urdf: arm.urdf\n" + drives)}).out;
  };
  EXPECT_THAT(
      shown("drives: {position_gain: 20, torque_rate: [1, 2, 3, 4, 5, 6], delay: 0.0015, rate: 500}\n"),
      testing::AllOf(HasSubstr("position_gain [1/s]: 20."),
                     HasSubstr("torque_rate [N m/s, N/s]: 1, 2, 3, 4, 5, 6."),
                     HasSubstr("delay [s]: 0.0015."), HasSubstr("rate [Hz]: 500.")));
  EXPECT_THAT(shown(""), testing::Not(HasSubstr("Drives of the robot file")));
}

// A mesh in millimetres, for example: it meets everything, so that its pairs would be left out without a
// word.
TEST(NewUser, IsWarnedOfAShapeThatIsLargerThanTheArm) {
  const test::TemporaryFolder folder;
  folder.write("arm.urdf", urdf_text(test::ur10()));
  const std::string shapes = "{forearm_link: [{capsule: {radius: 50, from: [0, 0, 0], to: [0, 0, 600]}}]}";
  const Finished shown =
      run_program({"robot", folder.write("arm.yaml", "{urdf: arm.urdf, shapes: " + shapes + "}\n")});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_THAT(shown.err, testing::AllOf(HasSubstr("forearm_link: "), HasSubstr("350 m")));
}

TEST(NewUser, ATaskIsNotPutIntoAFolderThatHoldsSomething) {
  const test::TemporaryFolder folder;
  folder.write("task.yaml", "mine\n");
  const Finished done = run_program({"robot", "ur10", "--task", folder.path()});
  EXPECT_EQ(done.exit_code, 2);
  EXPECT_EQ(test::read_text(folder / "task.yaml"), "mine\n");
}

TEST(NewUser, APathThatNoGainsCanFollowIsNamedBeforeItIsSimulated) {
  const test::TemporaryFolder folder;
  const std::string path =
      folder.write("far.yaml", "base: moving_target\nduration: 1\npath: {center: [-1.5, 0, 0.5]}\n");
  const Finished done = run_program({"simulate", path});
  EXPECT_THAT(done.err, testing::AllOf(HasSubstr("warning: far:"),
                                       HasSubstr("cannot place its tool at (-1.5, 0, 0.5) m")));
}

TEST(NewUser, ATuningWhoseStartFailsNamesThePathThatNoGainsCanFollow) {
  const test::ShortStudy files;
  // Over before the tool is on the path: there is nothing to be relative to.
  files.write("short.yaml", "base: moving_target\nduration: 1\npath: {center: [-1.5, 0, 0.5]}\n");
  const Finished done = run_program({"tune", files.path(), "--out", files / "run", "--workers", "2"});
  EXPECT_EQ(done.exit_code, 2) << done.out;
  EXPECT_THAT(done.err, testing::AllOf(HasSubstr("warning: short:"),
                                       HasSubstr("cannot place its tool at (-1.5, 0, 0.5) m")));
  EXPECT_LT(done.err.find("warning: short:"), done.err.find("study.yaml")) << done.err;
}

}  // namespace new_user_test
}  // namespace armtune::internal
