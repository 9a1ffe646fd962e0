// Standard output and disks that are full: results are written first, and what cannot be used is not left
// behind.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/support/program.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace full_disk_test {

namespace fs = std::filesystem;
using test::Finished;
using test::ShortStudy;

/// Runs the program with its standard output on a disk that is full.
Finished run_unprinted(const std::vector<std::string>& arguments, const std::string& folder) {
  return test::Program(arguments, folder, {"/bin/sh", "-c", "exec \"$@\" > /dev/full", "sh"}).wait();
}

class FullOutput : public testing::Test {
 protected:
  /// Expects that the command fails for its output alone, and leaves these files in the folder that it was
  /// told of. An empty name stands for that path itself, where the result is one file.
  void expect_results(std::vector<std::string> arguments, const std::vector<std::string>& results) {
    const std::string run = files_ / ("out_" + arguments.front());
    arguments.insert(arguments.end(), {"--out", run});
    const Finished done = run_unprinted(arguments, files_ / "");
    EXPECT_EQ(done.exit_code, 1) << done.err;
    EXPECT_THAT(done.err, testing::HasSubstr("armtune: "));
    for (const std::string& file : results)
      EXPECT_TRUE(fs::exists(file.empty() ? run : run + "/" + file)) << arguments.front() << " lost " << file;
  }

  const ShortStudy files_;
};

TEST_F(FullOutput, LosesNoneOfTheResults) {
  // Tables of more than a stream's buffer: several scenarios, and names that are long.
  const std::string long_name = files_ / (std::string(150, 'l') + ".yaml");
  fs::copy_file(files_ / "gains.yaml", long_name);
  std::vector<std::string> scenarios = {files_ / "short.yaml", files_ / "short_realistic.yaml"};
  for (const char* name : {"third", "fourth"}) {
    scenarios.push_back(files_ / (std::string(name) + ".yaml"));
    fs::copy_file(scenarios.front(), scenarios.back());
  }
  std::vector<std::string> simulate = {"simulate", "--gains", long_name};
  simulate.insert(simulate.begin() + 1, scenarios.begin(), scenarios.end());
  expect_results(simulate, {"errors.csv", "columns.csv", "gains.yaml", "run.json", "verdict.yaml"});

  std::vector<std::string> compare = {"compare", long_name, files_ / "gains.yaml", "--all-metrics",
                                      "--scenarios"};
  compare.insert(compare.end(), scenarios.begin(), scenarios.end());
  expect_results(compare, {"comparison.csv", "errors_gains.csv", "run.json", "verdict.yaml"});

  std::vector<std::string> robustness = {"robustness", files_ / "gains.yaml", "--samples", "2",
                                         "--scenarios"};
  robustness.insert(robustness.end(), scenarios.begin(), scenarios.end());
  expect_results(robustness, {"samples.csv", "summary.csv", "run.json", "verdict.yaml"});
}

TEST_F(FullOutput, OfASearchLosesNoneEither) {
  const std::string run = files_ / "run";
  const Finished done = run_unprinted({"tune", files_.path(), "--out", run, "--workers", "2"}, files_ / "");
  EXPECT_EQ(done.exit_code, 1) << done.err;
  for (const char* file :
       {"gains.yaml", "errors.csv", "run.json", "margins.csv", "sensitivity.csv", "verdict.yaml"})
    EXPECT_TRUE(fs::exists(run + "/" + file)) << file;
}

TEST_F(FullOutput, OfAnalysesOfARunLosesNone) {
  const std::string run = files_ / "run";
  ASSERT_THAT(test::run_program({"tune", files_.path(), "--out", run, "--no-analysis"}).exit_code,
              testing::AnyOf(0, 3));
  expect_results({"margins", run}, {"margins.csv", "run.json"});
  expect_results({"sensitivity", run}, {"sensitivity.csv", "reduced_study.yaml", "run.json"});
  expect_results({"yardstick", run, "--knots", "40"}, {""});
  expect_results({"export", run}, {""});
  expect_results({"report", run}, {""});
}

TEST_F(FullOutput, OfPlansLogsAndTasksLosesNone) {
  expect_results({"plan", "ur10_move", "--knots", "12"}, {"trajectory.csv", "limits.csv", "run.json"});
  expect_results({"excite", "ur10", "--scenario", "moving_target", "--evaluations", "20"},
                 {"excitation.yaml", "trajectory.csv", "log_moving_target.csv", "run.json"});
  expect_results({"identify", files_ / "out_excite/log_moving_target.csv", "--robot", "ur10", "--accept"},
                 {"theta.yaml", "base_parameters.csv", "robot.urdf", "robot.yaml", "run.json"});
  expect_results({"validate", files_ / "out_excite/log_moving_target.csv", "--robot", "ur10"},
                 {"residuals.csv", "run.json"});
  expect_results({"pareto", files_.path(), "--criteria", "objective", "effort_rate/rms", "--levels", "2",
                  "--max-evaluations", "6"},
                 {"pareto.csv", "points/01.yaml", "study.yaml", "run.json"});
}

// Where nothing could be written nothing was found either, as far as a script can tell.
TEST(FullDisk, NothingIsToldBeforeItIsWritten) {
  const ShortStudy files;
  const std::string no_folder =
      files / "gains.yaml/run";  // a file is in the way, and is seen when it is made
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"plan", "ur10_move", "--knots", "12"}, {"excite", "ur10", "--evaluations", "20"}}) {
    auto words = command;
    words.insert(words.end(), {"--out", no_folder});
    const Finished refused = test::run_program(words);
    EXPECT_EQ(refused.exit_code, 2) << command.front() << refused.err;
    EXPECT_THAT(refused.err, testing::HasSubstr(no_folder));
    EXPECT_EQ(refused.out, "") << command.front();
  }
}

TEST(FullDisk, ARunWhoseJournalCannotBeBegunLeavesNoFolder) {
  const ShortStudy files;
  const std::string run = files / "run";
  const std::vector<std::string> command = {
      "tune", files.path(), "--out", run, "--no-analysis", "--warm-start", files / "gains.yaml"};
  for (const char* blocks :
       {"0", "1", "8"}) {  // of 512 bytes: nothing, then half of what stands before the search
    const std::string full = std::string("ulimit -f ") + blocks + "; exec \"$@\" 2>&1 | cat > /dev/null";
    test::Program(command, files / "", {"/bin/sh", "-c", full, "sh"}).wait();
    EXPECT_FALSE(fs::exists(run)) << blocks;
  }
  const Finished again = test::run_program(command);
  EXPECT_THAT(again.exit_code, testing::AnyOf(0, 3)) << again.err;
}

}  // namespace full_disk_test
}  // namespace armtune::internal
