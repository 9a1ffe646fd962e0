// Commands as ranks of mpirun: the same files as with threads, and what happens to ranks that differ or end.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>

#include "tests/cli/support/program.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace ranks_test {

using test::Finished;
using test::Program;
using test::ShortStudy;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Strings = std::vector<std::string>;
using Clock = std::chrono::steady_clock;

const std::string kMpiexec = test::mpiexec_path();

class Ranks : public ::testing::Test {
 protected:
  void SetUp() override {
    if (kMpiexec.empty()) GTEST_SKIP() << "built without MPI";
    // Containers run tests as root, which mpirun refuses unless told otherwise.
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  }

  static Strings launcher(int ranks) {
    return {kMpiexec, "--oversubscribe", "--bind-to", "none", "-n", std::to_string(ranks)};
  }
  Finished run(int ranks, const Strings& arguments) const {
    return Program(arguments, folder_.path(), launcher(ranks)).wait();
  }
  /// The launcher of two ranks, the first with arguments of its own and the second with those to come. Each
  /// leaves its exit code in a file (code_of).
  Strings launcher_of_two(const Strings& first) const {
    Strings all = {kMpiexec, "--oversubscribe", "--bind-to", "none"};
    const auto add_rank = [&](int rank) {
      const std::string script = "\"$@\"; echo $? > '" + folder_ / ("code." + std::to_string(rank)) + "'";
      for (const std::string& word : Strings{"-n", "1", "sh", "-c", script, "sh"}) all.push_back(word);
    };
    add_rank(0);
    all.emplace_back(test::program_path());
    all.insert(all.end(), first.begin(), first.end());
    all.emplace_back(":");
    add_rank(1);
    return all;
  }
  std::string code_of(int rank) const { return test::read_text(folder_ / ("code." + std::to_string(rank))); }
  Finished alone(const Strings& arguments) const { return Program(arguments, folder_.path()).wait(); }
  static Strings tune(const std::string& study, const std::string& out, const Strings& more,
                      const char* evaluations = "6") {
    Strings all = {"tune", study, "--out", out, "--no-analysis", "--max-evaluations", evaluations};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  TemporaryFolder folder_;
};

/// All columns but the last, the time.
std::string without_time(const std::string& path) {
  std::istringstream lines(test::read_text(path));
  std::string all;
  for (std::string line; std::getline(lines, line);) all += line.substr(0, line.rfind(',')) + '\n';
  return all;
}

long rows(const std::string& path) {
  const std::string text = test::read_text(path);
  return std::count(text.begin(), text.end(), '\n') - 1;
}

bool wait_for_rows(Program& program, const std::string& path, long count) {
  const auto deadline = Clock::now() + std::chrono::seconds(120);
  while (rows(path) < count && program.running() && Clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return rows(path) >= count && program.running();
}

/// Process number of a rank below that mpirun, or 0.
int process_of(const Program& mpirun, int rank) {
  const std::string children = "/proc/" + std::to_string(mpirun.pid()) + "/task/";
  for (const auto& task : std::filesystem::directory_iterator(children)) {
    std::istringstream numbers(test::read_text(task.path().string() + "/children"));
    for (int pid = 0; numbers >> pid;) {
      const std::string environment = test::read_text("/proc/" + std::to_string(pid) + "/environ");
      const std::string wanted = "OMPI_COMM_WORLD_RANK=" + std::to_string(rank);
      if (('\0' + environment).find('\0' + wanted + '\0') != std::string::npos) return pid;
    }
  }
  return 0;
}

/// True if the program says `text` on its standard error within that time.
bool wait_for_error(Program& program, const std::string& text, std::chrono::seconds longest) {
  const auto deadline = Clock::now() + longest;
  const auto said = [&] { return program.err_so_far().find(text) != std::string::npos; };
  while (!said() && program.running() && Clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return said();
}

bool wait_for_end(Program& program, std::chrono::seconds longest) {
  const auto deadline = Clock::now() + longest;
  while (program.running() && Clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return !program.running();
}

std::size_t times_said(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST_F(Ranks, TuneTheSameByteForByteAsThreads) {
  const ShortStudy files;
  for (const char* workers : {"1", "2", "4"}) {
    const Finished done =
        alone(tune(files.path(), files / (std::string("threads") + workers), {"--workers", workers}));
    ASSERT_EQ(done.exit_code, 0) << done.err;
  }
  for (const int ranks : {1, 2, 4}) {
    const Finished done = run(ranks, tune(files.path(), files / ("ranks" + std::to_string(ranks)), {}));
    ASSERT_EQ(done.exit_code, 0) << done.err << done.out;
    EXPECT_EQ(done.out.find("study study:"), done.out.rfind("study study:")) << "only one rank speaks";
    if (ranks == 1) continue;  // alone it is one process with threads
    EXPECT_EQ(find_run_record(files / ("ranks" + std::to_string(ranks)))->workers, ranks);
  }
  const std::string expected = without_time(files / "threads1/evaluations.csv");
  ASSERT_FALSE(expected.empty());
  for (const char* folder : {"threads2", "threads4", "ranks1", "ranks2", "ranks4"}) {
    EXPECT_EQ(without_time(files / folder + "/evaluations.csv"), expected) << folder;
    for (const char* file : {"/gains.yaml", "/errors.csv", "/start/errors.csv"}) {
      EXPECT_EQ(test::read_text(files / folder + file), test::read_text(files / "threads1" + file))
          << folder << file;
    }
  }
}

// Ranks are told per job which engine simulates it: a search has both.
TEST_F(Ranks, SearchInTheNativeEngineAsOneProcessDoes) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         test::kShortNativeSearch);
  const Finished done = alone(tune(files.path(), files / "one", {"--workers", "1"}, "24"));
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const std::string expected = without_time(files / "one/evaluations.csv");
  for (const char* rows :
       {"start,simbody,", "start,native,", "sweep,native,", "search,native,", "verify,simbody,"}) {
    EXPECT_THAT(expected, HasSubstr(rows));
  }
  for (const int ranks : {2, 4}) {
    const std::string folder = "ranks" + std::to_string(ranks);
    const Finished parallel = run(ranks, tune(files.path(), files / folder, {}, "24"));
    ASSERT_EQ(parallel.exit_code, 0) << parallel.err;
    EXPECT_EQ(without_time(files / folder + "/evaluations.csv"), expected) << folder;
    for (const char* file :
         {"/gains.yaml", "/errors.csv", "/start/errors.csv", "/study.yaml", "/rollout_short.csv"}) {
      EXPECT_EQ(test::read_text(files / folder + file), test::read_text(files / "one" + file))
          << folder << file;
    }
  }
}

TEST_F(Ranks, FindTheSameFrontAndSensitivitiesAsThreads) {
  const ShortStudy files;
  ASSERT_EQ(alone(tune(files.path(), files / "run", {})).exit_code, 0);
  const auto sensitivity = [&](const std::string& out) {
    return Strings{"sensitivity", files / "run", "--out", files / out};
  };
  const auto pareto = [&](const std::string& out) {
    return Strings{"pareto", files.path(), "--levels", "2", "--max-evaluations", "18", "--out", files / out};
  };
  ASSERT_EQ(alone(sensitivity("s1")).exit_code, 0);
  ASSERT_EQ(run(2, sensitivity("s2")).exit_code, 0);
  EXPECT_EQ(test::read_text(files / "s2/sensitivity.csv"), test::read_text(files / "s1/sensitivity.csv"));
  const Finished threads = alone(pareto("p1"));
  const Finished ranks = run(2, pareto("p2"));
  EXPECT_EQ(ranks.exit_code, threads.exit_code) << ranks.err;
  EXPECT_FALSE(test::read_text(files / "p1/pareto.csv").empty());
  EXPECT_EQ(test::read_text(files / "p2/pareto.csv"), test::read_text(files / "p1/pareto.csv"));
  EXPECT_EQ(without_time(files / "p2/evaluations.csv"), without_time(files / "p1/evaluations.csv"));
}

TEST_F(Ranks, DrawTheSameArmsAsThreads) {
  const std::string scenario = folder_.write("short.yaml", "base: realistic_moving_target\nduration: 4\n");
  const auto robustness = [&](const std::string& out, const Strings& more) {
    Strings all = {"robustness", "extended_tuned", "--scenarios", scenario, "--samples",
                   "7",          "--out",          folder_ / out};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const Finished threads = alone(robustness("threads", {"--workers", "2"}));
  ASSERT_EQ(threads.exit_code, 3) << threads.err << "in 4 s nothing is tracked yet, so no arm passes";
  for (const int ranks : {2, 4}) {
    const std::string out = "ranks" + std::to_string(ranks);
    const Finished done = run(ranks, robustness(out, {}));
    ASSERT_EQ(done.exit_code, 3) << done.err;
    for (const char* file : {"/samples.csv", "/summary.csv"}) {
      EXPECT_EQ(test::read_text(folder_ / out + file), test::read_text(folder_ / "threads" + file))
          << out << file;
    }
  }
}

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
  const Strings another_program = {
      kMpiexec, "--oversubscribe", "-n", "1", test::program_path(), "tune", ":", "-n", "1", "sh",
      "-c",     "exec sleep 60"};
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
    Strings all = {kMpiexec, "--oversubscribe", "-n", "1", "--wdir", here / ".", test::program_path()};
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

}  // namespace ranks_test
}  // namespace armtune::internal
