// Folders and files that cannot be looked at: the message names the true cause, with the right exit code.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "tests/cli/support/program.hpp"
#include "tests/core/support/sanitized.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace wrong_cause_test {

namespace fs = std::filesystem;
using test::Finished;
using test::Program;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Starts the program as a user who may not read everything: root's rights are dropped.
std::vector<std::string> plain_user() {
  return ::getuid() == 0 ? std::vector<std::string>{"/usr/bin/setpriv", "--reuid=65534", "--regid=65534",
                                                    "--clear-groups"}
                         : std::vector<std::string>{};
}

/// Starts the program after some words of a shell.
std::vector<std::string> after(const std::string& words) {
  return {"/bin/sh", "-c", words + "; exec \"$0\" \"$@\""};
}

TEST(WrongCause, AFolderThatMayNotBeReadIsCalledThat) {
  if (::getuid() == 0 && !fs::exists("/usr/bin/setpriv")) GTEST_SKIP() << "root reads everything";
  const test::TemporaryFolder folder;
  const std::string closed = folder / "closed";
  fs::create_directories(closed);
  folder.write("closed/own.yaml", "base: moving_target\nduration: 1\n");
  fs::permissions(closed, fs::perms::none);
  if (Program({"--version"}, "/", plain_user()).wait().exit_code != 0) GTEST_SKIP() << "cannot drop rights";
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"simulate", "moving_target", "--out", closed},
        {"simulate", closed + "/own.yaml"},
        {"simulate", "moving_target", "--gains", closed + "/gains.yaml"},
        {"tune", "--resume", closed},
        {"report", closed},
        {"compare", closed},
        {"export", closed},
        {"identify", closed + "/log.csv", "--robot", "ur10"}}) {
    SCOPED_TRACE(arguments[0]);
    const Finished done = Program(arguments, "/", plain_user()).wait();
    EXPECT_EQ(done.exit_code, 2);
    EXPECT_THAT(done.err, AllOf(HasSubstr(closed), HasSubstr("Permission denied"), Not(HasSubstr("o such")),
                                Not(HasSubstr("not empty")), Not(HasSubstr("not exist"))));
  }
  // One that may be searched and written to, but not listed: whether it is empty cannot be told.
  constexpr fs::perms kUnlisted =
      fs::perms::owner_write | fs::perms::owner_exec | fs::perms::others_write | fs::perms::others_exec;
  fs::permissions(closed, kUnlisted);
  const Finished done = Program({"simulate", "moving_target", "--out", closed}, "/", plain_user()).wait();
  EXPECT_EQ(done.exit_code, 2);
  EXPECT_THAT(done.err, AllOf(HasSubstr("Permission denied"), Not(HasSubstr("not empty"))));
  fs::permissions(closed, fs::perms::owner_all);
}

/// Runs a command with few, then more files that it may open, until it succeeds.
void expect_too_few_files_named(const test::TemporaryFolder& folder,
                                const std::vector<std::string>& command) {
  bool named = false;
  for (int files = 4; files < 12; ++files) {
    SCOPED_TRACE(command.front() + " with " + std::to_string(files));
    const std::string run = folder / (command.front() + std::to_string(files));
    std::vector<std::string> words = command;
    words.insert(words.end(), {"--out", run});
    const Finished done = Program(words, folder.path(), after("ulimit -n " + std::to_string(files))).wait();
    // The loader itself needs some; from then on it is armtune that says so.
    if (done.exit_code == 127) continue;
    if (done.exit_code == 0 || done.exit_code == 3) break;
    EXPECT_THAT(done.exit_code, testing::AnyOf(1, 2)) << done.err;
    EXPECT_THAT(done.err, AllOf(HasSubstr("Too many open files"), Not(HasSubstr("not empty")),
                                Not(HasSubstr("no such file"))));
    // Two threads that write at once need one file more than the start did: then there is work to keep.
    if (fs::exists(run)) {
      const int resumed = Program({command.front(), "--resume", run}, folder.path()).wait().exit_code;
      EXPECT_THAT(resumed, testing::AnyOf(0, 3));
    }
    named = true;
  }
  EXPECT_TRUE(named);
}

TEST(WrongCause, TooFewFilesAreNamedAndLeaveNoFolderWithoutWork) {
  if (test::kSanitized) GTEST_SKIP() << "the undefined behaviour sanitizer opens files of its own";
  const test::TemporaryFolder folder;
  const std::string scenario = folder.write("own.yaml", "base: moving_target\nduration: 0.1\n");
  const test::ShortStudy study;
  expect_too_few_files_named(folder, {"simulate", scenario});
  expect_too_few_files_named(folder, {"tune", study.path(), "--max-evaluations", "2", "--no-analysis"});
}

TEST(WrongCause, ACurrentFolderThatIsGoneIsNamedAndNothingIsLeft) {
  const test::TemporaryFolder folder;
  const std::string gone = "mkdir gone && cd gone && rmdir ../gone";
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"tune", "ur10_gaze", "--max-evaluations", "2", "--out", folder / "run"},
        {"robustness", "published", "--samples", "2", "--out", folder / "run"},
        {"pareto", "ur10_gaze", "--max-evaluations", "2", "--out", folder / "run"},
        {"simulate", "moving_target", "--out", folder / "run"},
        {"tune", "--resume", "somewhere"}}) {
    SCOPED_TRACE(arguments[0]);
    const Finished done = Program(arguments, folder.path(), after(gone)).wait();
    EXPECT_EQ(done.exit_code, 2) << done.err;
    EXPECT_THAT(done.err, Not(HasSubstr("filesystem error")));
    EXPECT_FALSE(fs::exists(folder / "run"));
  }
}

TEST(WrongCause, ASidecarThatCannotBeMadeIsRefused) {
  const test::TemporaryFolder folder;
  const std::string arm = folder.write(
      "arm.urdf",
      "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='revolute'><parent link='a'/>"
      "<child link='b'/><axis xyz='0 0 1'/><limit lower='-1' upper='1' velocity='0' "
      "effort='0'/></joint></robot>");
  const std::string loop = folder / "loop.yaml";
  fs::create_symlink(loop, loop);
  for (const std::string& path :
       {loop, folder / (std::string(300, 'n') + ".yaml"), folder / "none/arm.yaml"}) {
    const Finished done = Program({"robot", arm, "--sidecar", path}, folder.path()).wait();
    EXPECT_EQ(done.exit_code, 2) << done.err;
    EXPECT_THAT(done.err, AllOf(testing::StartsWith("armtune: /"), Not(HasSubstr("failed"))));
  }
}

TEST(WrongCause, ARecordingThatDoesNotFitIsRefusedBeforeTheFolderIsMade) {
  const test::TemporaryFolder folder;
  const std::string far = folder.write("far.yaml", "base: moving_target\nduration: 2e5\n");
  const std::vector<std::string> limited = after("ulimit -v 2000000");
  if (Program({"--version"}, folder.path(), limited).wait().exit_code != 0)
    GTEST_SKIP() << "the address sanitizer takes terabytes of addresses for itself";
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"simulate", far, "--record-every", "1", "--out", folder / "run"},
        {"compare", "published", "--scenarios", far, "--out", folder / "run"},
        {"robustness", "published", "--scenarios", far, "--samples", "1", "--out", folder / "run"}}) {
    const Finished done = Program(arguments, folder.path(), limited).wait();
    EXPECT_EQ(done.exit_code, 2) << done.err;
    EXPECT_THAT(done.err, AllOf(HasSubstr("far"), HasSubstr("GB"), HasSubstr("duration")));
    EXPECT_FALSE(fs::exists(folder / "run"));
  }
}

}  // namespace wrong_cause_test
}  // namespace armtune::internal
