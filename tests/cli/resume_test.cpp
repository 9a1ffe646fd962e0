// Killed at any moment, a run resumes as if it had not been.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/cli/support/killed_run.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace resume_test {

namespace fs = std::filesystem;
using test::expect_same_run;
using test::Finished;
using test::finished_in;
using test::lines_of;
using test::Program;
using test::run_and_kill;
using test::run_program;
using test::ShortStudy;
using testing::AllOf;
using testing::HasSubstr;

TEST(Resume, ATuningKilledAgainAndAgainEndsAsIfItHadNotBeen) {
  const ShortStudy files;
  const std::vector<std::string> begin = {"tune", files.path(), "--no-analysis", "--seed", "3"};
  auto with = [&begin](const std::string& folder) {
    auto all = begin;
    all.insert(all.end(), {"--out", folder});
    return all;
  };
  ASSERT_EQ(run_program(with(files / "whole")).exit_code, 0);
  run_and_kill(with(files / "killed"), files / "killed/journal.txt", 3);
  const std::vector<std::string> resume = {"tune", "--resume", files / "killed", "--workers", "1"};
  run_and_kill(resume, files / "killed/journal.txt", 7);
  const std::size_t finished = finished_in(files / "killed/journal.txt");
  const Finished ended = run_program(resume);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(fmt::format("resuming after {} finished evaluations", finished)));
  expect_same_run(files / "whole", files / "killed",
                  {"gains.yaml", "errors.csv", "study.yaml", "rollout_short.csv"});
  EXPECT_EQ(finished_in(files / "killed/journal.txt"), lines_of(files / "whole/evaluations.csv") - 1)
      << "no finished evaluation was repeated";

  const std::string before = test::read_text(files / "killed/run.json");
  const Finished again = run_program(resume);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.out, AllOf(HasSubstr("there is nothing to resume"), HasSubstr("--warm-start")));
  EXPECT_EQ(test::read_text(files / "killed/run.json"), before);
}

TEST(Resume, ANativeSearchKilledInItsLastStepsEndsAsIfItHadNotBeen) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         test::kShortNativeSearch);
  ASSERT_EQ(run_program({"tune", files.path(), "--no-analysis", "--out", files / "whole"}).exit_code, 0);
  run_and_kill({"tune", files.path(), "--no-analysis", "--out", files / "killed"},
               files / "killed/journal.txt", 19);
  EXPECT_THAT(test::read_text(files / "killed/journal.txt"), HasSubstr("\tverify\t")) << "in its last steps";
  ASSERT_EQ(run_program({"tune", "--resume", files / "killed"}).exit_code, 0);
  expect_same_run(files / "whole", files / "killed", {"gains.yaml", "errors.csv", "study.yaml"});
  EXPECT_EQ(finished_in(files / "killed/journal.txt"), lines_of(files / "whole/evaluations.csv") - 1);
}

TEST(Resume, AnInterruptedNativeSearchLeavesSimbodysFigures) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         test::kShortNativeSearch);
  const test::TemporaryFolder folder;
  Program program({"tune", files.path(), "--no-analysis", "--out", files / "run"}, folder.path());
  while (program.running() && finished_in(files / "run/journal.txt") < 6) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  program.interrupt();
  const Finished ended = program.wait();
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_THAT(test::read_text(files / "run/gains.yaml"), testing::Not(HasSubstr("not yet simulated")));
  ASSERT_EQ(run_program({"simulate", files / "short.yaml", files / "short_realistic.yaml", "--gains",
                         files / "run/gains.yaml", "--out", files / "again"})
                .exit_code,
            0);
  EXPECT_EQ(test::read_text(files / "run/errors.csv"), test::read_text(files / "again/errors.csv"));
}

// What was recorded is recalled first, whenever the signal comes: files never hold less than before.
TEST(Resume, AnInterruptWhileItRecallsLosesNothing) {
  const ShortStudy files;
  run_and_kill({"tune", files.path(), "--no-analysis", "--out", files / "run"}, files / "run/journal.txt", 8);
  const std::size_t finished = finished_in(files / "run/journal.txt");
  const test::TemporaryFolder folder;
  for (const int wait : {0, 10, 20, 30, 40, 60}) {
    Program program({"tune", "--resume", files / "run", "--workers", "1"}, folder.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(wait));
    program.interrupt();
    const Finished ended = program.wait();
    // Before the program listens to signals one ends it, and nothing was touched. On a busy machine the run
    // may end before the signal arrives.
    EXPECT_THAT(ended.exit_code, testing::AnyOf(0, 130, -1)) << ended.err;
    if (ended.exit_code != -1) {
      EXPECT_GE(lines_of(files / "run/evaluations.csv"), finished + 1) << wait;
    }
  }
  ASSERT_EQ(run_program({"tune", files.path(), "--no-analysis", "--out", files / "whole"}).exit_code, 0);
  ASSERT_EQ(run_program({"tune", "--resume", files / "run"}).exit_code, 0);
  expect_same_run(files / "whole", files / "run", {"gains.yaml", "errors.csv"});
}

TEST(Resume, AWarmStartIsThereFromTheFirstMoment) {
  const ShortStudy files;
  std::string warm = test::read_text(files / "gains.yaml");
  const std::string own = "slerpDurationErrorGain: 2.5";
  ASSERT_NE(warm.find(own), std::string::npos);
  warm.replace(warm.find(own), own.size(), "slerpDurationErrorGain: 2.2");
  files.write("warm.yaml", warm);
  const auto with = [&files](const std::string& folder) {
    return std::vector<std::string>{
        "tune", files.path(), "--no-analysis", "--warm-start", files / "warm.yaml", "--out", folder};
  };
  ASSERT_EQ(run_program(with(files / "whole")).exit_code, 0);
  run_and_kill(with(files / "killed"), files / "killed/journal.txt", 1);
  fs::remove(files / "warm.yaml");
  const Finished ended = run_program({"tune", "--resume", files / "killed"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  expect_same_run(files / "whole", files / "killed", {"gains.yaml", "errors.csv", "start/warm_gains.yaml"});
}

TEST(Resume, AFrontKilledEndsAsIfItHadNotBeen) {
  const ShortStudy files;
  const std::vector<std::string> begin = {"pareto", files.path(), "--levels", "2", "--max-evaluations", "24"};
  auto with = [&begin](const std::string& folder) {
    auto all = begin;
    all.insert(all.end(), {"--out", folder});
    return all;
  };
  ASSERT_EQ(run_program(with(files / "whole")).exit_code, 0);
  run_and_kill(with(files / "killed"), files / "killed/journal.txt", 9);
  ASSERT_EQ(run_program({"pareto", "--resume", files / "killed"}).exit_code, 0);
  expect_same_run(files / "whole", files / "killed", {"pareto.csv", "study.yaml", "points/01.yaml"});
}

TEST(Resume, SamplesOfAKilledRunAreNotDrawnAgain) {
  const ShortStudy files;
  const std::vector<std::string> begin = {"robustness",
                                          files / "gains.yaml",
                                          "--scenarios",
                                          files / "short.yaml",
                                          files / "short_realistic.yaml",
                                          "--samples",
                                          "9",
                                          "--seed",
                                          "4"};
  auto with = [&begin](const std::string& folder) {
    auto all = begin;
    all.insert(all.end(), {"--out", folder});
    return all;
  };
  ASSERT_EQ(run_program(with(files / "whole")).exit_code, 0);
  run_and_kill(with(files / "killed"), files / "killed/journal.txt", 4);
  const Finished ended = run_program({"robustness", "--resume", files / "killed"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("resuming after "));
  for (const char* file : {"/samples.csv", "/summary.csv"}) {
    EXPECT_EQ(test::read_text(files / "whole" + file), test::read_text(files / "killed" + file)) << file;
  }
  EXPECT_EQ(finished_in(files / "killed/journal.txt"), 9U);
}

TEST(Resume, AnInterruptedRunSaysHowToGoOn) {
  const ShortStudy files;
  const test::TemporaryFolder folder;
  Program program({"tune", files.path(), "--no-analysis", "--out", files / "run"}, folder.path());
  while (program.running() && finished_in(files / "run/journal.txt") < 3) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  program.interrupt();
  const Finished ended = program.wait();
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_THAT(ended.out, HasSubstr("tune --resume " + (files / "run")));
  ASSERT_EQ(run_program({"tune", files.path(), "--no-analysis", "--out", files / "whole"}).exit_code, 0);
  ASSERT_EQ(run_program({"tune", "--resume", files / "run"}).exit_code, 0);
  expect_same_run(files / "whole", files / "run", {"gains.yaml", "errors.csv"});
}

}  // namespace resume_test
}  // namespace armtune::internal
