#include "tuner/planning/session/plan_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "sim/csv/csv_table.hpp"
#include "sim/logs/log_reader.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune::internal {
namespace plan_session_test {

namespace fs = std::filesystem;

PlanSettings settings_in(const std::string& folder) {
  PlanSettings settings;
  settings.folder = folder;
  settings.task = load_plan_task("ur10_switch");
  settings.task.knots = 40;
  return settings;
}

TEST(PlanSession, WithAndWithoutAFolderThePlanIsThatOfTheSolver) {
  const std::atomic<bool> never{false};
  const test::TemporaryFolder files;
  SessionObserver silent;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const PlanOutcome bare = PlanSession(settings_in(""), {never}, silent).run();
  const PlanOutcome kept = PlanSession(settings_in(files / "run"), {never}, silent).run();
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  const PlannedTrajectory solved = solve_plan(plan_problem(settings_in("").task));
  ASSERT_EQ(solved.result.status, PlanStatus::kSolved);
  for (const PlanOutcome* outcome : {&bare, &kept}) {
    ASSERT_EQ(outcome->planned.result.status, PlanStatus::kSolved);
    EXPECT_EQ(outcome->planned.trajectory.durations, solved.trajectory.durations);
    EXPECT_FALSE(outcome->uses.empty());
  }
  EXPECT_TRUE(bare.files.empty());
  EXPECT_FALSE(kept.files.empty());
  for (const std::string& file : kept.files)
    EXPECT_TRUE(fs::is_regular_file(files / ("run/" + file))) << file;
}

TEST(PlanSession, WritesItsMotionAsAnMcapFileIfAsked) {
  const std::atomic<bool> never{false};
  const test::TemporaryFolder files;
  SessionObserver silent;
  PlanSettings settings = settings_in(files / "run");
  settings.mcap = true;
  const PlanOutcome outcome = PlanSession(settings, {never}, silent).run();
  EXPECT_THAT(outcome.files, testing::Contains("motion.mcap"));
  const CsvTable motion = CsvTable::read(files / "run/motion.csv");
  LogSelection selection;
  selection.topics = {"/joint_states"};
  const Log log = read_log(files / "run/motion.mcap", selection);
  ASSERT_EQ(log.topics.size(), 1U);
  const LogTopic& states = log.topics[0];
  ASSERT_EQ(states.time.size(), motion.rows());
  const std::size_t time = motion.find("time").value();
  for (std::size_t i = 0; i < states.labels.size(); ++i) {
    const auto position = motion.find("joint/" + states.labels[i] + "/position");
    ASSERT_TRUE(position) << states.labels[i];
    for (std::size_t row = 0; row < motion.rows(); ++row) {
      EXPECT_EQ(states.channels[i].value[row], motion.number(row, *position));
      EXPECT_NEAR(log.start + states.time[row], motion.number(row, time), 1e-8);
    }
  }
}

TEST(PlanSession, InterruptedItLeavesNothing) {
  const std::atomic<bool> stop{true};
  const test::TemporaryFolder files;
  SessionObserver silent;
  const PlanOutcome outcome = PlanSession(settings_in(files / "run"), {stop}, silent).run();
  EXPECT_EQ(outcome.planned.result.status, PlanStatus::kInterrupted);
  EXPECT_TRUE(outcome.files.empty());
  EXPECT_FALSE(fs::exists(files / "run"));
}

}  // namespace plan_session_test
}  // namespace armtune::internal
