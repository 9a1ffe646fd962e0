// Programs without a terminal: closed streams, full disks behind them, a terminal that goes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include "tests/cli/support/program.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace detached_test {

using test::Finished;
using test::Program;
using test::read_text;
using testing::HasSubstr;

/// What the shell does with the program's streams.
std::vector<std::string> shell(const std::string& streams) {
  return {"/bin/sh", "-c", "exec \"$0\" \"$@\" " + streams};
}

std::vector<std::string> tune(const test::ShortStudy& files, const std::string& run) {
  return {"tune", files.path(), "--out", files / run, "--workers", "1", "--no-analysis"};
}

// The lowest free numbers are given to the files that are opened next: the journal among them.
TEST(Detached, AClosedStreamIsNotTakenForTheJournal) {
  const test::ShortStudy files;
  ASSERT_EQ(Program(tune(files, "run"), files / "").wait().exit_code, 0);
  for (const char* closed : {"<&- >&- 2>&-", ">&-", "2>&-"}) {
    SCOPED_TRACE(closed);
    const std::string run = std::string("run") + closed[0] + closed[1];
    EXPECT_EQ(Program(tune(files, run), files / "", shell(closed)).wait().exit_code, 0);
    for (const char* file : {"/gains.yaml", "/errors.csv"})
      EXPECT_EQ(read_text(files / run + file), read_text(files / "run" + file)) << file;
    const Finished again = test::run_program({"tune", "--resume", files / run});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_THAT(read_text(files / run + "/journal.txt"), testing::Not(HasSubstr("study study:")));
    std::filesystem::remove_all(files / run);
  }
}

TEST(Detached, WhatCannotBePrintedIsAFailure) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const std::vector<std::vector<std::string>> all = {
      {"export", "published"}, {"robot", "ur10"}, {"--version"}, {"export", "published", "--format", "ros1"}};
  for (const auto& arguments : all) {
    const test::TemporaryFolder folder;
    const Finished done = Program(arguments, folder.path(), shell("> /dev/full")).wait();
    EXPECT_EQ(done.exit_code, 1) << arguments[0];
    EXPECT_THAT(done.err, HasSubstr("No space left on device"));
  }
}

TEST(Detached, AnErrorThatCannotBePrintedStillHasItsExitCode) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const test::ShortStudy files;
  for (const char* streams : {"2> /dev/full", "> /dev/full 2> /dev/full"}) {
    SCOPED_TRACE(streams);
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"simulate", "nowhere"},
                                                      {"simulate", files / "nowhere.yaml"},
                                                      {"tune", "--frob"},
                                                      {}}) {
      EXPECT_EQ(Program(arguments, files / "", shell(streams)).wait().exit_code, 2);
    }
  }
  // Warnings and notes beside the work do not end it either.
  const std::string far =
      files.write("far.yaml", "base: moving_target\nduration: 1\npath: {center: [-1.5, 0, 0.5]}\n");
  const Finished warned = Program({"simulate", far, "--out", files / "far"}, files / "").wait();
  ASSERT_THAT(warned.err, HasSubstr("warning"));
  const Finished silent =
      Program({"simulate", far, "--out", files / "silent"}, files / "", shell("2> /dev/full")).wait();
  EXPECT_EQ(silent.exit_code, warned.exit_code);
  EXPECT_EQ(read_text(files / "silent/errors.csv"), read_text(files / "far/errors.csv"));
}

TEST(Detached, ResultsAreWrittenWhereTablesCannotBePrinted) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const test::ShortStudy files;
  const auto simulate = [&files](const std::string& run, const std::string& streams) {
    std::vector<std::string> arguments = {"simulate", "--out", files / run};
    for (char name = 'a'; name <= 'p'; ++name) {
      arguments.push_back(files.write(std::string(1, name) + ".yaml", "base: moving_target\nduration: 1\n"));
    }
    return Program(arguments, files / "", shell(streams)).wait();
  };
  const Finished done = simulate("run", "");
  ASSERT_GT(done.out.size(), std::size_t{BUFSIZ})
      << "a table that fits the buffer of the stream shows nothing";
  const Finished full = simulate("full", "> /dev/full");
  EXPECT_EQ(full.exit_code, done.exit_code == 0 ? 1 : done.exit_code) << full.err;
  for (const char* file : {"/gains.yaml", "/errors.csv", "/verdict.yaml", "/rollout_a.csv"}) {
    ASSERT_TRUE(std::filesystem::exists(files / "full" + file)) << file;
    EXPECT_TRUE(read_text(files / "full" + file) == read_text(files / "run" + file)) << file;
  }
}

TEST(Detached, AReaderThatHasEnoughDoesNotEndTheRun) {
  const test::ShortStudy files;
  const Finished whole = Program(tune(files, "run"), files / "").wait();
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  // The shell's exit code is that of head; armtune's goes into a file.
  for (const char* reader : {"head -n 1", "true"}) {
    SCOPED_TRACE(reader);
    const std::string pipe = std::string("{ \"$0\" \"$@\"; echo $? > code; } | ") + reader;
    const Finished cut = Program(tune(files, "cut"), files / "", {"/bin/sh", "-c", pipe}).wait();
    EXPECT_EQ(read_text(files / "code"), "0\n") << cut.err;
    EXPECT_EQ(cut.err, whole.err);
    EXPECT_EQ(read_text(files / "cut/gains.yaml"), read_text(files / "run/gains.yaml"));
    EXPECT_EQ(test::run_program({"tune", "--resume", files / "cut"}).exit_code, 0) << "finished";
    std::filesystem::remove_all(files / "cut");
  }
}

TEST(Detached, ATerminalThatClosesInterruptsARunAndNohupDoesNot) {
  const test::ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                               "search: {algorithm: CRS2, max_evaluations: 30, seed: 1}\n");
  const auto hung_up = [&](const std::string& run, const std::vector<std::string>& launcher) {
    Program program(tune(files, run), files / "", launcher);
    while (program.running() && !std::filesystem::exists(files / run + "/evaluations.csv")) {
    }
    EXPECT_EQ(::kill(program.pid(), SIGHUP), 0);
    return program.wait();
  };
  const Finished interrupted = hung_up("closed", {});
  EXPECT_EQ(interrupted.exit_code, 130) << interrupted.err;
  EXPECT_TRUE(std::filesystem::exists(files / "closed/gains.yaml"));
  const Finished outlived = hung_up("outlived", {"/usr/bin/nohup"});
  EXPECT_EQ(outlived.exit_code, 0) << outlived.err;
}

}  // namespace detached_test
}  // namespace armtune::internal
