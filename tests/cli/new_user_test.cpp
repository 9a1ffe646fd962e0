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
namespace {

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
                                       HasSubstr("cannot have its tool at (-1.5, 0, 0.5) m")));
}

TEST(NewUser, ATuningWhoseStartFailsNamesThePathThatNoGainsCanFollow) {
  const test::ShortStudy files;
  // Over before the tool is on the path: there is nothing to be relative to.
  files.write("short.yaml", "base: moving_target\nduration: 1\npath: {center: [-1.5, 0, 0.5]}\n");
  const Finished done = run_program({"tune", files.path(), "--out", files / "run", "--workers", "2"});
  EXPECT_EQ(done.exit_code, 2) << done.out;
  EXPECT_THAT(done.err, testing::AllOf(HasSubstr("warning: short:"),
                                       HasSubstr("cannot have its tool at (-1.5, 0, 0.5) m")));
  EXPECT_LT(done.err.find("warning: short:"), done.err.find("study.yaml")) << done.err;
}

}  // namespace
}  // namespace armtune::internal
