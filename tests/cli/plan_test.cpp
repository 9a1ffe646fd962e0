#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "tests/cli/support/program.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/report/support/decode.hpp"
#include "tuner/report/report.hpp"

namespace armtune::internal {
namespace plan_test {

using test::Finished;
using test::run_program;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

/// Waits until the program has its handler of SIGINT, as the kernel tells; false after a minute.
bool catches_interrupts(const test::Program& program) {
  for (int i = 0; i < 6000; ++i) {
    std::ifstream status("/proc/" + std::to_string(program.pid()) + "/status");
    for (std::string line; std::getline(status, line);) {
      constexpr unsigned long long kSigint = 1ULL << (SIGINT - 1);
      if (line.starts_with("SigCgt:") && (std::stoull(line.substr(7), nullptr, 16) & kSigint) != 0)
        return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST(Plan, WritesATrajectoryAndSaysWhatHoldsItBack) {
  const test::TemporaryFolder folder;
  const std::string out = folder / "switch";
  const Finished planned = run_program({"plan", "ur10_switch", "--knots", "60", "--out", out});
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_THAT(planned.out,
              AllOf(HasSubstr("least time found within the limits"), HasSubstr("velocity of wrist_2_joint"),
                    HasSubstr("between the knots: torque of"), HasSubstr("constraint violation"),
                    HasSubstr("KKT residual")));
  for (const char* file : {"trajectory.csv", "motion.csv", "limits.csv", "joint_trajectory.yaml", "task.yaml",
                           "columns.csv", "run.json", "scene.json"}) {
    EXPECT_TRUE(std::filesystem::exists(out + "/" + file)) << file;
  }
  EXPECT_EQ(test::read_csv(out + "/trajectory.csv").rows.size(), 61U);

  const test::Csv columns = test::read_csv(out + "/columns.csv");
  std::set<std::string> described;
  for (const auto& row : columns.rows) described.insert(row.at(0) + ":" + row.at(1));
  std::size_t there = 0;
  for (const std::string file : {"trajectory.csv", "motion.csv", "limits.csv"}) {
    for (const std::string& column : test::read_csv(out + "/" + file).header) {
      EXPECT_EQ(described.count(file + ":" + column), 1U) << file << " " << column;
      ++there;
    }
  }
  EXPECT_EQ(described.size(), there) << "and nothing that is not there";

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
  // A plan at the whole of a limit leaves feedback no room: it passes limits by a percent, and the verdict
  // says so.
  EXPECT_EQ(followed.exit_code, 3) << followed.err;
  EXPECT_THAT(followed.out, HasSubstr("Simulation checks: failed"));
  EXPECT_THAT(followed.out, AllOf(HasSubstr("joint_error/max [rad]"), HasSubstr("reacquisition/time")));
  const test::Csv errors = test::read_csv(folder / "run/errors.csv");
  EXPECT_EQ(errors.at(0, "scenario"), "planned_ur10_switch");
  EXPECT_EQ(errors.at(0, "status"), "completed");
  EXPECT_LT(std::stod(errors.at(0, "joint_error/max")), 1e-3);
  const test::Csv rollout = test::read_csv(folder / "run/rollout_planned_ur10_switch.csv");
  EXPECT_EQ(rollout.at(0, "time"), "8");
  EXPECT_EQ(rollout.at(0, "state"), "4");
  // What it was made from is on record: also the plan.
  EXPECT_THAT(test::read_text(folder / "run/run.json"), HasSubstr("trajectory.csv"));

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
  EXPECT_THAT(
      planned.out,
      AllOf(ContainsRegex(
                "infeasible: the limits allow no less than 0\\.5[0-9]+ s, but the duration is 0\\.4 s"),
            HasSubstr("limits that prevent a shorter time:"),
            ContainsRegex("velocity of [a-z0-9_]+: -?[0-9.]+ rad/s, at [0-9.]+ % of the knots, ")));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Plan, InterruptedEndsWith130AndLeavesNothing) {
  const test::TemporaryFolder folder;
  test::Program running({"plan", "ur10_fastest_circle", "--knots", "20000", "--out", folder / "circle"},
                        folder.path());
  ASSERT_TRUE(catches_interrupts(running));
  running.interrupt();
  const Finished finished = running.wait();
  EXPECT_EQ(finished.exit_code, 130) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("interrupted; no trajectory was written"));
  EXPECT_FALSE(std::filesystem::exists(folder / "circle"));
}

TEST(Plan, ShowsItsProgressOnATerminalAndNothingOfItInAFile) {
  const std::vector<std::string> words = {"plan", "ur10_lap", "--knots", "60", "--out"};
  const test::TemporaryFolder folder;
  std::vector<std::string> here = words;
  here.push_back(folder / "file");
  EXPECT_EQ(run_program(here).err, "");
  const std::string script = "/usr/bin/script";
  if (!std::filesystem::exists(script)) GTEST_SKIP() << "no terminal to be had without " << script;
  std::vector<std::string> there = words;
  there.push_back(folder / "terminal");
  const Finished shown =
      test::Program(there, folder.path(), {"/bin/sh", "-c", script + " -qec \"$*\" /dev/null", "sh"}).wait();
  EXPECT_EQ(shown.exit_code, 0) << shown.out;
  EXPECT_THAT(shown.out,
              AllOf(HasSubstr("first guess"), HasSubstr("61 knots, step 1"), HasSubstr("KKT residual")));
}

TEST(Plan, LeavesAReportThatReportMakesAgain) {
  const test::TemporaryFolder folder;
  const std::string out = folder / "move";
  ASSERT_EQ(run_program({"plan", "ur10_move", "--knots", "40", "--out", out}).exit_code, 0);
  if (!report::available()) GTEST_SKIP() << "built without the page";
  const std::string page = test::read_text(out + "/report.html");
  EXPECT_LE(page.size(), 6'000'000U);
  EXPECT_EQ(run_program({"report", out}).exit_code, 0);
  EXPECT_EQ(test::read_text(out + "/report.html"), page);
  const yaml::Node data = test::parsed(test::data_of(page));
  EXPECT_EQ(test::at(data, "kind").as_string(), "plan");
  EXPECT_THAT(test::at(data, "verdict/sentence").as_string(),
              HasSubstr("held back by velocity of elbow_joint"));
  EXPECT_EQ(test::at(data, "robots/0/joints").items().size(), 6U);
  EXPECT_GT(test::at(data, "scenarios/0/runs/0/replay/n").as_integer(), 100);
  EXPECT_THAT(test::at(data, "provenance/command").as_string(), HasSubstr("plan ur10_move --knots 40"));
  for (const char* group : {"joint_position", "joint_velocity", "joint_acceleration", "joint_torque"}) {
    int columns = 0;
    for (const yaml::Node& column : test::at(data, "scenarios/0/runs/0/columns").items())
      columns += test::at(column, "group").as_string() == group ? 1 : 0;
    EXPECT_EQ(columns, 6) << group;
  }
}

TEST(Plan, FromARolloutItIsAmongTheInputsAndFoundFromTheFolderOfThePlan) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "my task");
  const Finished simulated = run_program({"simulate", "moving_target", "--out", folder / "my task/run"});
  ASSERT_EQ(simulated.exit_code, 3) << simulated.err << "the published gains saturate the elbow at 6 s";
  const std::string task = folder.write("my task/back.yaml",
                                        "task: return\nscenario: moving_target\nat: 3\nknots: 40\n"
                                        "start: {rollout: run/rollout_moving_target.csv}\n");
  const Finished planned = run_program({"plan", task, "--out", folder / "plan"});
  ASSERT_EQ(planned.exit_code, 0) << planned.err << planned.out;
  EXPECT_THAT(test::read_text(folder / "plan/run.json"),
              HasSubstr("rollout_moving_target.csv\", \"hash\": "));
  const Finished again = run_program({"plan", folder / "plan/task.yaml", "--out", folder / "again"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(test::read_text(folder / "again/trajectory.csv"),
            test::read_text(folder / "plan/trajectory.csv"));
}

TEST(Plan, BadInputEndsWithTwo) {
  EXPECT_EQ(run_program({"plan", "no_such_task"}).exit_code, 2);
  EXPECT_EQ(run_program({"plan", "ur10_move", "--knots", "2"}).exit_code, 2);
  EXPECT_EQ(run_program({"plan", "ur10_move", "--ros", "3"}).exit_code, 2);
}

}  // namespace plan_test
}  // namespace armtune::internal
