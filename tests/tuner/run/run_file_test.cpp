// The way from a run's folder to its files never leads elsewhere.

#include "tuner/run/run_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace run_file_test {

namespace fs = std::filesystem;
using test::refused_at;

class RunFile : public testing::Test {
 protected:
  RunFile() {
    fs::create_directories(files_ / "run/start");
    files_.write("run/start/errors.csv", "");
    files_.write("outside.csv", "");
  }
  test::TemporaryFolder files_;
  std::string run_ = files_ / "run";
};

TEST_F(RunFile, FindsWhatIsThereAndNothingElse) {
  EXPECT_EQ(find_run_file(run_, "start/errors.csv"), run_ + "/start/errors.csv");
  EXPECT_EQ(run_file(run_, "start/errors.csv"), run_ + "/start/errors.csv");
  for (const char* name : {"errors.csv", "tuned/errors.csv", "start/errors.csv/more"})
    EXPECT_EQ(find_run_file(run_, name), std::nullopt) << name;
  EXPECT_THAT(test::refusal([&] { run_file(run_, "errors.csv"); }),
              testing::StartsWith(run_ + "/errors.csv: "));
}

TEST_F(RunFile, RefusesNamesThatLeadOutOfTheFolder) {
  const std::string zero("start/errors.csv\0.csv", 21);
  for (const std::string& name :
       {std::string("../outside.csv"), std::string("start/../../outside.csv"), files_ / "outside.csv",
        std::string(), zero, std::string("rollout_/../x.csv")})
    EXPECT_THAT([&] { find_run_file(run_, name); }, refused_at({.file = run_})) << name;
}

TEST_F(RunFile, RefusesLinksAlsoOnTheWayAndAlsoWhereTheyLeadInside) {
  fs::create_symlink(files_ / "outside.csv", run_ + "/errors.csv");
  fs::create_symlink("start/errors.csv", run_ + "/inside.csv");
  fs::create_symlink(files_ / "nowhere", run_ + "/dangling.csv");
  fs::create_directory_symlink(run_ + "/start", run_ + "/tuned");
  for (const std::string name : {"errors.csv", "inside.csv", "dangling.csv"})
    EXPECT_THAT([&] { find_run_file(run_, name); }, refused_at({.file = run_ + "/" + name}));
  EXPECT_THAT([&] { find_run_file(run_, "tuned/errors.csv"); }, refused_at({.file = run_ + "/tuned"}));
}

TEST_F(RunFile, RefusesWhatIsNoFile) {
  ASSERT_EQ(::mkfifo((run_ + "/pipe.csv").c_str(), 0600), 0);
  EXPECT_THAT([&] { find_run_file(run_, "pipe.csv"); }, refused_at({.file = run_ + "/pipe.csv"}));
  EXPECT_THAT([&] { find_run_file(run_, "start"); }, refused_at({.file = run_ + "/start"}));
}

TEST_F(RunFile, WhereThereIsALinkNothingIsWritten) {
  EXPECT_NO_THROW(refuse_links(run_));
  fs::create_directory_symlink(run_, files_ / "latest");
  EXPECT_NO_THROW(refuse_links(files_ / "latest"));
  for (const std::string name : {"rollouts", "start/gains.yaml"}) {
    fs::create_symlink(files_ / "outside.csv", run_ + "/" + name);
    EXPECT_THAT([&] { refuse_links(run_); }, refused_at({.file = run_ + "/" + name}));
    fs::remove(run_ + "/" + name);
  }
  EXPECT_THAT([&] { refuse_links(files_ / "nowhere"); }, refused_at({.file = files_ / "nowhere"}));
}

TEST_F(RunFile, TheFolderItselfMayBeALink) {
  fs::create_directory_symlink(run_, files_ / "latest");
  EXPECT_TRUE(find_run_file(files_ / "latest", "start/errors.csv"));
}

}  // namespace run_file_test
}  // namespace armtune::internal
