// `armtune margins` as a person runs it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/cli/support/program.hpp"
#include "tests/cli/support/refused_command.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace margins_test {

using test::Finished;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;

/// A short study's gains and one scenario of 5 s.
class MarginsProgram : public testing::Test {
 protected:
  Finished margins(std::vector<std::string> more) const {
    std::vector<std::string> args = {"margins", files_ / "gains.yaml", "--scenarios", scenario_};
    args.insert(args.end(), more.begin(), more.end());
    return run_program(args);
  }

  const test::ShortStudy files_;
  const test::TemporaryFolder folder_;
  const std::string scenario_ = folder_.write("five_seconds.yaml", "base: moving_target\nduration: 5\n");
};

TEST_F(MarginsProgram, WritesTheSameFileWithAnyNumberOfWorkers) {
  const Finished one = margins({"--out", folder_ / "one", "--workers", "1"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.err, "");
  EXPECT_THAT(one.out,
              AllOf(HasSubstr("torque_delay [periods]"), HasSubstr("five_seconds"),
                    HasSubstr("the closed loop fails at gain_factor "), HasSubstr("margins.csv, run.json")));
  const Finished two = margins({"--out", folder_ / "two", "--workers", "2"});
  ASSERT_EQ(two.exit_code, 0) << two.err;
  const std::string csv = test::read_text(folder_ / "one/margins.csv");
  EXPECT_THAT(csv, HasSubstr("\ncontrol_rate,Hz,all,500,"));
  EXPECT_EQ(test::read_text(folder_ / "two/margins.csv"), csv);
  EXPECT_THAT(test::read_text(folder_ / "one/run.json"),
              AllOf(HasSubstr("five_seconds.yaml"), HasSubstr("gains.yaml")));
}

TEST_F(MarginsProgram, SaysSoWhereNotEvenTheNominalStands) {
  const Finished strict = margins({"--limit", "joint_velocity/max_ratio<=0.01"});
  EXPECT_EQ(strict.exit_code, 3) << strict.err;
  EXPECT_THAT(strict.out, AllOf(HasSubstr("none"), HasSubstr("fails in five_seconds without any change"),
                                HasSubstr("breaks joint_velocity/max_ratio <= 0.01")));
}

TEST_F(MarginsProgram, BadInputEndsWithTwo) {
  const std::vector<std::string> one = {"margins", files_ / "gains.yaml", "--scenarios", scenario_};
  std::vector<std::string> limit = one;
  limit.insert(limit.end(), {"--out", folder_ / "limit", "--limit", "speed<=1"});
  EXPECT_THAT(test::refused_command(limit), test::refused_at({.key = "limit", .value = "speed"}));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "limit"));
  std::vector<std::string> twice = one;
  twice.push_back(scenario_);
  EXPECT_THAT(test::refused_command(twice).what(), HasSubstr("two scenarios have the name five_seconds"));
  EXPECT_THAT(test::refused_command({"margins", "nowhere"}), test::refused_at({.value = "nowhere"}));
}

TEST_F(MarginsProgram, AnInterruptKeepsWhatIsFinished) {
  test::Program program({"margins", "published", "--out", "cut"}, folder_.path());
  const auto rows = [&] {
    const std::string text = test::read_text(folder_ / "cut/margins.csv");
    return std::count(text.begin(), text.end(), '\n') - 1;
  };
  while (program.running() && rows() < 1) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(program.running());
  EXPECT_GE(rows(), 1) << "on disk while the rest is searched";
  program.interrupt();
  const Finished cut = program.wait();
  EXPECT_EQ(cut.exit_code, 130) << cut.err;
  EXPECT_THAT(test::read_text(folder_ / "cut/margins.csv"),
              testing::StartsWith("margin,unit,scenario,nominal,stands,fails,reason\n"));
  EXPECT_GE(rows(), 1);
}

}  // namespace margins_test
}  // namespace armtune::internal
