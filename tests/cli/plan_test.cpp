#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

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

TEST(Plan, LeavesAScenarioThatFollowsIt) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(run_program({"plan", "ur10_switch", "--knots", "60", "--out", folder / "plan"}).exit_code, 0);
  const std::string scenario = folder / "plan/planned_ur10_switch.yaml";
  const Finished followed = run_program({"simulate", scenario, "--out", folder / "run"});
  EXPECT_EQ(followed.exit_code, 0) << followed.err;
  EXPECT_THAT(followed.out, AllOf(HasSubstr("joint_error/max [rad]"), HasSubstr("reacquisition/time")));
  const test::Csv errors = test::read_csv(folder / "run/errors.csv");
  EXPECT_EQ(errors.at(0, "scenario"), "planned_ur10_switch");
  EXPECT_EQ(errors.at(0, "status"), "completed");
  EXPECT_LT(std::stod(errors.at(0, "joint_error/max")), 1e-3);
  const test::Csv rollout = test::read_csv(folder / "run/rollout_planned_ur10_switch.csv");
  EXPECT_EQ(rollout.at(0, "time"), "8");
  EXPECT_EQ(rollout.at(0, "state"), "4");
  // What it was made from is on record: also the plan.
  EXPECT_THAT(test::read_text(folder / "run/run.yaml"), HasSubstr("trajectory.csv"));

  // A plan that is not one any more is refused by line and column.
  std::string plan = test::read_text(folder / "plan/trajectory.csv");
  plan.resize(plan.rfind('\n', plan.size() - 2) + 1);
  std::ofstream(folder / "plan/trajectory.csv") << plan << "9,1\n";
  const Finished refused = run_program({"simulate", scenario});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("trajectory.csv:"), HasSubstr("cells")));
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
