#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/support/program.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune {
namespace {

using test::Finished;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;

TEST(Plan, WritesATrajectoryAndSaysWhatHoldsItBack) {
  const test::TemporaryFolder folder;
  const std::string out = folder / "switch";
  const Finished planned = run_program({"plan", "ur10_switch", "--knots", "60", "--out", out});
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_THAT(planned.out,
              AllOf(HasSubstr("least time found within the limits"), HasSubstr("velocity of wrist_2_joint"),
                    HasSubstr("constraint violation"), HasSubstr("KKT residual")));
  for (const char* file :
       {"trajectory.csv", "joint_trajectory.yaml", "task.yaml", "columns.csv", "run.yaml"}) {
    EXPECT_TRUE(std::filesystem::exists(out + "/" + file)) << file;
  }
  EXPECT_EQ(test::read_csv(out + "/trajectory.csv").rows.size(), 61U);

  // The resolved task gives the same motion, to the byte; a folder in use is left alone.
  const Finished again =
      run_program({"plan", out + "/task.yaml", "--knots", "60", "--out", folder / "again"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(test::read_text(folder / "again/trajectory.csv"), test::read_text(out + "/trajectory.csv"));
  EXPECT_EQ(run_program({"plan", "ur10_switch", "--out", out}).exit_code, 2);
}

TEST(Plan, AnInfeasibleTaskEndsWithThreeAndNamesTheLimitInTheWay) {
  const test::TemporaryFolder folder;
  const std::string out = folder / "move";
  const Finished planned =
      run_program({"plan", "ur10_move", "--duration", "0.4", "--knots", "60", "--out", out});
  EXPECT_EQ(planned.exit_code, 3) << planned.err;
  EXPECT_THAT(planned.out,
              AllOf(HasSubstr("infeasible: goal of"), HasSubstr("in the way:"), HasSubstr("velocity of")));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Plan, BadInputEndsWithTwo) {
  EXPECT_EQ(run_program({"plan", "no_such_task"}).exit_code, 2);
  EXPECT_EQ(run_program({"plan", "ur10_move", "--knots", "2"}).exit_code, 2);
  EXPECT_EQ(run_program({"plan", "ur10_move", "--ros", "3"}).exit_code, 2);
}

}  // namespace
}  // namespace armtune
