// The option --xacro, with a program that stands in for xacro in PATH.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/cli/support/program.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace xacro_option_test {

using test::Finished;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;

class XacroOption : public testing::Test {
 protected:
  XacroOption() {
    const char* path = std::getenv("PATH");
    path_ = path == nullptr ? "" : path;
    ::setenv("PATH", (folder_.path() + ":" + path_).c_str(), 1);
    const std::string program = folder_.write(
        "xacro",
        "#!/bin/sh\n[ \"$2\" = kind:=six ] || { echo 'Undefined argument kind' >&2; exit 2; }\ncat '" +
            std::string(test::source_dir()) + "/sim/robots/ur10.urdf'\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }
  ~XacroOption() override { ::setenv("PATH", path_.c_str(), 1); }

  test::TemporaryFolder folder_;
  std::string path_;
  const std::string arm_ = folder_.write(
      "arm.urdf.xacro",
      "<robot name='ur10' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arm kind='$(arg kind)'/></robot>");
};

TEST_F(XacroOption, ExpandsARobotAndNamesTheCommand) {
  const Finished plain = run_program({"robot", arm_});
  EXPECT_EQ(plain.exit_code, 2);
  EXPECT_THAT(plain.err, AllOf(HasSubstr("xacro " + arm_ + " > arm.urdf"), HasSubstr("--xacro")));
  const Finished expanded = run_program({"robot", arm_, "--xacro", "--xacro-argument", "kind:=six"});
  ASSERT_EQ(expanded.exit_code, 0) << expanded.err;
  EXPECT_THAT(expanded.out, HasSubstr("wrist_3_joint"));
  EXPECT_THAT(expanded.err, HasSubstr("running: " + folder_.path() + "/xacro " + arm_ + " kind:=six\n"));
  EXPECT_EQ(expanded.err.find("running"), expanded.err.rfind("running")) << "once, however often it is read";
}

TEST_F(XacroOption, ItsErrorsEndWithTwo) {
  const Finished undefined = run_program({"robot", "--xacro", arm_});
  EXPECT_EQ(undefined.exit_code, 2);
  EXPECT_THAT(undefined.err, HasSubstr("Undefined argument kind"));
  EXPECT_EQ(run_program({"robot", "--xacro", "--xacro-argument", "kind=six", arm_}).exit_code, 2);
  EXPECT_EQ(run_program({"robot", "--xacro-argument", "kind:=six", arm_}).exit_code, 2) << "without --xacro";
}

TEST_F(XacroOption, EveryCommandThatReadsRobotsHasIt) {
  const std::string scenario = folder_.write("task.yaml", "base: moving_target\nrobot: arm.urdf.xacro\n");
  const std::vector<std::string> xacro = {"--xacro", "--xacro-argument", "kind:=five"};
  for (std::vector<std::string> command : {std::vector<std::string>{"simulate", scenario},
                                           {"margins", "extended", "--scenarios", scenario},
                                           {"export", "extended", "--robot", arm_},
                                           {"compare", "extended", "--scenarios", scenario}}) {
    command.insert(command.end(), xacro.begin(), xacro.end());
    const Finished refused = run_program(command);
    EXPECT_EQ(refused.exit_code, 2) << command.front();
    EXPECT_THAT(refused.err, HasSubstr("Undefined argument kind")) << command.front();
  }
}

}  // namespace xacro_option_test
}  // namespace armtune::internal
