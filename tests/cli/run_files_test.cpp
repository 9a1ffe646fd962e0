// Commands that read a run folder follow no link inside it and wait for no pipe.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/cli/support/program.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/report/report.hpp"

namespace armtune::internal {
namespace run_files_test {

namespace fs = std::filesystem;
using test::Finished;
using test::run_program;
using testing::HasSubstr;

/// A command over a run folder, and a file of that folder which it reads.
struct Reader {
  std::vector<std::string> words;  ///< RUN stands for the folder
  std::string file;
};

class RunFiles : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<test::ShortStudy>();
    ASSERT_EQ(run_program({"tune", made_->path(), "--out", *made_ / "run", "--no-analysis"}).exit_code, 0);
    ASSERT_EQ(run_program({"margins", *made_ / "run", "--out", *made_ / "margins"}).exit_code, 0);
    fs::copy_file(*made_ / "margins/margins.csv", *made_ / "run/margins.csv");
  }
  static void TearDownTestSuite() { made_.reset(); }

  RunFiles() { fs::copy(*made_ / "run", run_, fs::copy_options::recursive); }

  Finished run(const Reader& reader) const {
    std::vector<std::string> words = reader.words;
    for (std::string& word : words) {
      if (word == "RUN") word = run_;
      if (word == "STUDY") word = made_->path();
    }
    return run_program(words);
  }

  const std::vector<Reader> readers_ = {
      {{"export", "RUN"}, "gains.yaml"},
      {{"export", "RUN"}, "run.json"},
      {{"export", "RUN"}, "errors.csv"},
      {{"export", "RUN"}, "margins.csv"},
      {{"compare", "published", "RUN", "--scenarios", "moving_target"}, "gains.yaml"},
      {{"compare", "published", "RUN"}, "study.yaml"},
      {{"robustness", "RUN", "--samples", "2"}, "study.yaml"},
      {{"sensitivity", "RUN"}, "study.yaml"},
      {{"sensitivity", "RUN"}, "gains.yaml"},
      {{"sensitivity", "RUN"}, "evaluations.csv"},
      {{"yardstick", "RUN"}, "gains.yaml"},
      {{"yardstick", "RUN"}, "run.json"},
      {{"yardstick", "RUN"}, "rollout_short.csv"},
      {{"tune", "--resume", "RUN"}, "journal.txt"},
      {{"tune", "STUDY", "--warm-start", "RUN", "--out", "warm"}, "gains.yaml"}};

  static std::unique_ptr<test::ShortStudy> made_;
  const test::TemporaryFolder files_;
  const std::string run_ = files_ / "run";
};

std::unique_ptr<test::ShortStudy> RunFiles::made_;

TEST_F(RunFiles, OfEveryKindAreNotFollowedWhereTheyAreLinks) {
  for (const Reader& reader : readers_) {
    const std::string file = run_ + "/" + reader.file;
    fs::rename(file, files_ / "elsewhere");
    fs::create_symlink(files_ / "elsewhere", file);
    const Finished refused = run(reader);
    EXPECT_EQ(refused.exit_code, 2) << reader.words.front() << ": " << refused.err;
    EXPECT_THAT(refused.err, testing::AllOf(HasSubstr(file), HasSubstr("link"))) << reader.words.front();
    fs::remove(file);
    fs::rename(files_ / "elsewhere", file);
  }
}

TEST_F(RunFiles, OfEveryKindAreNotWaitedForWhereTheyArePipes) {
  for (const Reader& reader : readers_) {
    const std::string file = run_ + "/" + reader.file;
    fs::rename(file, files_ / "elsewhere");
    ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    const Finished refused = run(reader);
    EXPECT_EQ(refused.exit_code, 2) << reader.words.front() << ": " << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(file)) << reader.words.front();
    fs::remove(file);
    fs::rename(files_ / "elsewhere", file);
  }
}

TEST_F(RunFiles, ThePageOfARunIsReplacedAndAUsersOwnFileIsNot) {
  if (!report::available()) GTEST_SKIP() << "the page is not built in";
  files_.write("mine.html", "mine");
  files_.write("page.html.partial", "mine too");
  fs::create_symlink(files_ / "nowhere", files_ / "link.html");
  EXPECT_EQ(run_program({"report", run_}).exit_code, 0) << "its own is there already";
  for (const char* name : {"mine.html", "link.html"}) {
    const Finished refused = run_program({"report", run_, "--out", files_ / name});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr(files_ / name));
  }
  EXPECT_EQ(test::read_text(files_ / "mine.html"), "mine");
  EXPECT_EQ(run_program({"report", run_, "--out", files_ / "page.html"}).exit_code, 0);
  EXPECT_EQ(test::read_text(files_ / "page.html"), test::read_text(run_ + "/report.html"));
  EXPECT_EQ(test::read_text(files_ / "page.html.partial"), "mine too");
}

}  // namespace run_files_test
}  // namespace armtune::internal
