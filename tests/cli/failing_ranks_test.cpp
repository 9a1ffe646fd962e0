// Commands as ranks of mpirun: what happens to ranks that hang, end, differ or do not start.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "tests/cli/support/program.hpp"
#include "tests/cli/support/ranks.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace failing_ranks_test {

using test::Finished;
using test::process_of;
using test::Program;
using test::Ranks;
using test::rows;
using test::ShortStudy;
using test::TemporaryFolder;
using test::times_said;
using test::wait_for_end;
using test::wait_for_error;
using test::wait_for_rows;
using test::without_time;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Strings = std::vector<std::string>;
using Clock = std::chrono::steady_clock;

TEST_F(Ranks, AKilledRankOrLauncherEndsTheRunWithWhatIsFinishedOnDisk) {
  const ShortStudy files;
  ASSERT_EQ(alone(tune(files.path(), files / "whole", {}, "12")).exit_code, 0);
  for (const std::string whose : {"rank 1", "rank 0", "launcher"}) {
    SCOPED_TRACE(whose);
    const std::string folder = files / whose;
    Program running(tune(files.path(), folder, {}, "12"), folder_.path(), launcher(2));
    ASSERT_TRUE(wait_for_rows(running, folder + "/evaluations.csv", 4)) << running.wait().err;
    const std::vector<int> ranks = {process_of(running, 0), process_of(running, 1)};
    ASSERT_GT(std::min(ranks[0], ranks[1]), 0);
    ASSERT_EQ(::kill(whose == "launcher" ? running.pid() : ranks[whose == "rank 1" ? 1 : 0], SIGKILL), 0);
    const auto killed = Clock::now();
    EXPECT_NE(running.wait().exit_code, 0);
    const auto alive = [](int pid) {
      return !test::read_text("/proc/" + std::to_string(pid) + "/cmdline").empty();
    };
    while (std::any_of(ranks.begin(), ranks.end(), alive) &&
           Clock::now() - killed < std::chrono::seconds(20)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_LT(Clock::now() - killed, std::chrono::seconds(10));
    EXPECT_GE(rows(folder + "/evaluations.csv"), 4);
    EXPECT_TRUE(test::read_text(folder + "/evaluations.csv").ends_with('\n'));

    const Finished resumed = run(2, {"tune", "--resume", folder});
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_EQ(without_time(folder + "/evaluations.csv"), without_time(files / "whole/evaluations.csv"));
    for (const char* file : {"/gains.yaml", "/errors.csv"}) {
      EXPECT_EQ(test::read_text(folder + file), test::read_text(files / "whole" + file)) << file;
    }
  }
}

TEST_F(Ranks, AHungRankIsToldApartFromASlowOne) {
  const ShortStudy files;
  Program running(tune(files.path(), files / "run", {"--rollout-deadline", "10"}, "100000"), folder_.path(),
                  launcher(2));
  ASSERT_TRUE(wait_for_rows(running, files / "run/evaluations.csv", 2)) << running.wait().err;
  const int victim = process_of(running, 1);
  ASSERT_GT(victim, 0);
  ASSERT_EQ(::kill(victim, SIGSTOP), 0);
  const Finished hung = running.wait();
  EXPECT_EQ(hung.exit_code, 1);
  EXPECT_EQ(times_said(hung.err, "armtune: waiting for rank 1 on "), 1U) << hung.err;
  EXPECT_EQ(times_said(hung.err, "armtune: failed: "), 1U) << hung.err;
  EXPECT_THAT(hung.err,
              AllOf(HasSubstr("rank 1 on "), HasSubstr("has not answered for 15 s"), HasSubstr("it hangs")));
  EXPECT_GE(rows(files / "run/evaluations.csv"), 2);

  const Finished slow = run(2, tune(files.path(), files / "slow", {"--rollout-deadline", "0.001"}));
  EXPECT_EQ(slow.exit_code, 1);
  EXPECT_THAT(slow.err, AllOf(HasSubstr("deadline of 0.001 s"), HasSubstr("--rollout-deadline"),
                              Not(HasSubstr("hangs"))));
}

// The wait is that for the job which the rank was given; what it computes afterwards is what it would have.
TEST_F(Ranks, AStarvedRankIsNamedOnceAndWaitedFor) {
  const ShortStudy files;
  ASSERT_EQ(alone(tune(files.path(), files / "whole", {}, "12")).exit_code, 0);
  Program running(tune(files.path(), files / "run", {}, "12"), folder_.path(), launcher(2));
  ASSERT_TRUE(wait_for_rows(running, files / "run/evaluations.csv", 4)) << running.wait().err;
  const int victim = process_of(running, 1);
  ASSERT_GT(victim, 0);
  ASSERT_EQ(::kill(victim, SIGSTOP), 0);
  const auto stopped = Clock::now();
  EXPECT_TRUE(wait_for_error(running, "waiting for rank 1 on ", std::chrono::seconds(30)));
  EXPECT_GE(Clock::now() - stopped, std::chrono::seconds(9));
  ASSERT_EQ(::kill(victim, SIGCONT), 0);
  const Finished done = running.wait();
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(times_said(done.err, "waiting for rank"), 1U) << done.err;
  EXPECT_EQ(without_time(files / "run/evaluations.csv"), without_time(files / "whole/evaluations.csv"));
}

TEST_F(Ranks, ARankThatDoesNotStartIsSaid) {
  const Strings another_program = {test::mpiexec_path(),
                                   "--oversubscribe",
                                   "-n",
                                   "1",
                                   test::program_path(),
                                   "tune",
                                   ":",
                                   "-n",
                                   "1",
                                   "sh",
                                   "-c",
                                   "exec sleep 60"};
  Program running({}, folder_.path(), another_program);
  EXPECT_TRUE(wait_for_error(running, "waited for ", std::chrono::seconds(30)));
  EXPECT_THAT(running.err_so_far(), HasSubstr("rank 0 on "));
  running.interrupt();
  EXPECT_TRUE(wait_for_end(running, std::chrono::seconds(20)));
}

TEST_F(Ranks, RanksWithDifferentCommandLinesAllEnd) {
  const Strings study = {"tune", "ur10_gaze", "--max-evaluations", "5", "--out", folder_ / "run"};
  Strings longer = study;
  longer.emplace_back("--no-analysis");
  const Strings others[] = {{"simulate", "moving_target"},
                            {"robustness", "published"},
                            {"sensitivity", "nowhere"},
                            {"--version"},
                            {"tune", "--help"},
                            {"tune", "--no-such-option"},
                            {},
                            longer};
  for (const Strings& other : others) {
    for (const bool leads : {false, true}) {
      SCOPED_TRACE((other.empty() ? "nothing" : other.front() + " " + other.back()) +
                   (leads ? " in rank 0" : " in rank 1"));
      Program running(leads ? study : other, folder_.path(), launcher_of_two(leads ? other : study));
      ASSERT_TRUE(wait_for_end(running, std::chrono::seconds(60))) << running.err_so_far();
      const Finished done = running.wait();
      EXPECT_EQ(code_of(0), "2\n");
      EXPECT_EQ(code_of(1), "2\n");
      EXPECT_EQ(done.out, "");
      EXPECT_EQ(times_said(done.err, "armtune: rank 1 on "), 1U) << done.err;
      EXPECT_THAT(done.err, AllOf(HasSubstr("command line"), HasSubstr("tune ur10_gaze")));
      EXPECT_THAT(done.err, HasSubstr(other.empty() ? "armtune" : other.back()));
    }
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run"));
}

// The words are the same, but not what they name.
TEST_F(Ranks, ARankWithAnotherStudyOrNoneIsRefused) {
  const ShortStudy here;
  const ShortStudy there;
  const TemporaryFolder nowhere;
  std::filesystem::copy(here / "gains.yaml", there / "gains.yaml",
                        std::filesystem::copy_options::overwrite_existing);
  there.write("short.yaml", "base: moving_target\nduration: 7\n");
  const auto both = [&](const std::string& second) {
    const Strings words = tune("study.yaml", here / "run", {});
    Strings all = {test::mpiexec_path(), "--oversubscribe",   "-n", "1", "--wdir",
                   here / ".",           test::program_path()};
    all.insert(all.end(), words.begin(), words.end());
    for (const std::string& word : Strings{":", "-n", "1", "--wdir", second}) all.push_back(word);
    return Program(words, folder_.path(), all).wait();
  };
  const Finished other = both(there / ".");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.err,
              AllOf(HasSubstr("rank 1 on "), HasSubstr("of short: 7 s"), HasSubstr("rank 0 has 8 s")));
  const Finished none = both(nowhere.path());
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, AllOf(HasSubstr("rank 1 on "), HasSubstr("study.yaml")));
  EXPECT_FALSE(std::filesystem::exists(here / "run"));
}

TEST_F(Ranks, BadInputIsSaidOnceWhoeverSeesIt) {
  const Finished missing = run(3, {"tune", "nowhere.yaml"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_EQ(times_said(missing.err, "armtune: "), 1U) << missing.err;
  const Finished usage = run(2, {"tune", "--no-such-option"});
  EXPECT_EQ(usage.exit_code, 2);
  EXPECT_EQ(times_said(usage.err, "--no-such-option"), 1U) << usage.err;
  const Finished threads = run(2, {"tune", "ur10_gaze", "--workers", "4"});
  EXPECT_EQ(threads.exit_code, 2);
  EXPECT_THAT(threads.err, HasSubstr("start more ranks instead"));
  const Finished version = run(2, {"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(times_said(version.out, "simbody"), 1U);
}

TEST_F(Ranks, OtherCommandsDoNotUseThem) {
  for (const Strings& command : {Strings{"simulate", "moving_target"}, Strings{"robot", "ur10"}}) {
    const Finished refused = run(2, command);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(times_said(refused.err, command.front() + " does not use MPI ranks"), 1U) << refused.err;
    EXPECT_EQ(refused.out, "");
  }
  EXPECT_EQ(run(1, {"robot", "ur10"}).exit_code, 0) << "one rank is a program like any other";
}

}  // namespace failing_ranks_test
}  // namespace armtune::internal
