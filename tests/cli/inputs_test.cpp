// Files that are edited while a run uses them.

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/cli/support/program.hpp"
#include "tests/tuner/run/support/records.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {
namespace inputs_test {

using test::Finished;
using test::ShortStudy;
using testing::HasSubstr;

/// Waits for the journal's first record, or the end of the program.
void wait_for_record(test::Program& program, const std::string& run) {
  while (program.running() && test::read_text(run + "/journal.txt").find(" finished\t") == std::string::npos)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

TEST(Inputs, EditedDuringARunAreToldOfAndKeptAsTheyWereRead) {
  const ShortStudy files;
  const std::string run = files / "run";
  const std::vector<std::string> inputs = {files / "short.yaml", files / "short_realistic.yaml",
                                           files / "gains.yaml", files.path()};
  std::vector<std::string> hashes;
  std::vector<std::string> texts;
  for (const std::string& file : inputs) {
    hashes.push_back(hash_of_file(file));
    texts.push_back(test::read_text(file));
  }
  test::Program program({"tune", files.path(), "--out", run, "--workers", "1", "--no-analysis"}, files / "");
  wait_for_record(program, run);
  ASSERT_TRUE(program.running());
  files.write("short.yaml", "base: moving_target\nduration: 9\n");
  files.write("short_realistic.yaml", "no longer a scenario\n");
  files.write("gains.yaml", "nor gains\n");
  files.write("study.yaml", "nor a study\n");
  const Finished done = program.wait();
  ASSERT_THAT(done.exit_code, testing::AnyOf(0, 3)) << done.err;

  const RunRecord told = find_run_record(run).value();
  const std::string journal = test::read_text(run + "/journal.txt");
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const InputFact input = test::input_in(told, inputs[i]);
    EXPECT_EQ(input.hash, hashes[i]) << inputs[i];
    EXPECT_EQ(test::read_text(run + "/" + input.copy), texts[i]);
  }
  for (const std::size_t scenario : {0U, 1U}) EXPECT_THAT(journal, HasSubstr(hashes[scenario]));
  // The robot's files are kept as well.
  EXPECT_NE(test::input_in(told, "bundled robots/ur10.urdf").copy, "");
  for (const InputFact& input : told.inputs) {
    if (input.copy.empty()) continue;
    EXPECT_EQ(hash_of_file(run + "/" + input.copy), input.hash) << input.path;
  }
}

TEST(Inputs, EditedAfterTheyWereReadAreToldOfAsTheyWereRead) {
  const ShortStudy files;
  const std::string run = files / "run";
  ASSERT_THAT(test::run_program({"tune", files.path(), "--out", run, "--no-analysis"}).exit_code,
              testing::AnyOf(0, 3));
  const std::string evaluations = run + "/evaluations.csv";
  const std::string before = hash_of_file(evaluations);
  // The folder is made when everything has been read; the search for what matters takes much longer.
  const std::string out = files / "sensitivity";
  test::Program program({"sensitivity", run, "--out", out, "--workers", "1"}, files / "");
  while (program.running() && !std::filesystem::exists(out))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  files.write("run/evaluations.csv", test::read_text(evaluations) + "edited\n");
  ASSERT_TRUE(program.running());
  const Finished done = program.wait();
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(test::input_in(find_run_record(out).value(), evaluations).hash, before);
}

TEST(Inputs, ThatChangedSinceTheRunAreRefusedByItsAnalyses) {
  const ShortStudy files;
  const Finished tuned =
      test::Program({"tune", "study.yaml", "--out", "run", "--max-evaluations", "2", "--no-analysis"},
                    files / "")
          .wait();
  ASSERT_THAT(tuned.exit_code, testing::AnyOf(0, 3)) << tuned.err;
  files.write("short.yaml", "base: moving_target\nduration: 9\n");
  for (const char* command : {"sensitivity", "yardstick"}) {
    const Finished refused = test::Program({command, "run"}, files / "").wait();
    EXPECT_EQ(refused.exit_code, 2) << command;
    EXPECT_THAT(refused.err, HasSubstr("short.yaml: this file has changed since the run")) << command;
  }
}

TEST(Inputs, FromAPipeAreReadOnceAndHashed) {
  const ShortStudy files;
  const std::string from_pipe = "cat " + (files / "gains.yaml") + " | exec \"$@\" --gains /dev/stdin";
  const Finished done = test::Program({"simulate", files / "short.yaml", "--out", files / "run"}, files / "",
                                      {"/bin/sh", "-c", from_pipe, "sh"})
                            .wait();
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(test::input_in(find_run_record(files / "run").value(), "/dev/stdin").hash,
            hash_of_file(files / "gains.yaml"));
}

TEST(Inputs, OneInterruptEndsTheWaitForAPipe) {
  const ShortStudy files;
  const std::string pipe = files / "gains.fifo";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  test::Program waiting({"simulate", files / "short.yaml", "--gains", pipe}, files / "");
  // It can be opened for writing as soon as somebody reads it.
  int writer = -1;
  while (writer < 0 && waiting.running()) {
    writer = ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  waiting.interrupt();
  const Finished done = waiting.wait();
  ::close(writer);
  EXPECT_EQ(done.exit_code, 130) << done.err;
  EXPECT_THAT(done.err, testing::AllOf(testing::HasSubstr("gains.fifo"), testing::HasSubstr("interrupted")));
}

}  // namespace inputs_test
}  // namespace armtune::internal
