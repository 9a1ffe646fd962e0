// `armtune robustness` as a person runs it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "sim/yaml/document.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/cli/support/refused_command.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/sim/support/arm_distributions.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/run/support/records.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {
namespace robustness_test {

using test::Finished;
using test::Program;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;

/// Fourteen seconds of target_switch on the realistic arm.
std::string short_scenario(const test::TemporaryFolder& folder) {
  return folder.write("short.yaml", "base: realistic_target_switch\nduration: 14\n");
}

Finished robustness(const test::TemporaryFolder& folder, const std::string& scenario, const std::string& out,
                    std::vector<std::string> more) {
  std::vector<std::string> args = {"robustness", "extended_tuned", "--scenarios",
                                   scenario,     "--out",          folder / out};
  args.insert(args.end(), more.begin(), more.end());
  return run_program(args);
}

TEST(Robustness, OneSeedGivesTheSameFilesAndASampleAloneItsRow) {
  const test::TemporaryFolder folder;
  const std::string scenario = short_scenario(folder);
  const Finished one = robustness(folder, scenario, "one", {"--samples", "3", "--workers", "1"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_THAT(
      one.out,
      AllOf(HasSubstr("of 3 random arms keep every limit"), HasSubstr("95 % confidence"),
            HasSubstr("Simulation checks: passed (yield)"),
            HasSubstr(
                "Note: 3 of 3 random arms keep the limits, with saturated torque in at most 1 % of the ")));
  const Finished two = robustness(folder, scenario, "two", {"--samples", "3", "--workers", "2"});
  ASSERT_EQ(two.exit_code, 0) << two.err;
  for (const char* file : {"/samples.csv", "/summary.csv"}) {
    EXPECT_EQ(test::read_text(folder / "one" + file), test::read_text(folder / "two" + file)) << file;
  }
  const Finished alone = robustness(folder, scenario, "alone", {"--sample", "2"});
  ASSERT_EQ(alone.exit_code, 0) << alone.err;
  const std::string row = test::read_text(folder / "alone/samples.csv");
  EXPECT_THAT(test::read_text(folder / "one/samples.csv"), HasSubstr(row.substr(row.find('\n') + 1)));
}

TEST(Robustness, NamesTheLimitThatIsBroken) {
  const test::TemporaryFolder folder;
  const Finished strict = robustness(folder, short_scenario(folder), "strict",
                                     {"--samples", "2", "--limit", "joint_velocity/max_ratio<=0.01"});
  EXPECT_EQ(strict.exit_code, 3) << strict.err;
  EXPECT_THAT(strict.out,
              AllOf(HasSubstr("0.0 % of 2 random arms"),
                    HasSubstr("2 of 2 random arms break 'joint_velocity/max_ratio <= 0.01'"),
                    HasSubstr("sample numbers 0 1"), HasSubstr("Simulation checks: failed: yield, "),
                    HasSubstr("threshold 0.95\nNot checked: ")));
  // A limit in place of the arm's own leaves those unchecked that it does not imply.
  EXPECT_THAT(strict.out, AllOf(HasSubstr("joint_position/min_margin >= 0, because --limit replaces it"),
                                testing::Not(HasSubstr("joint_velocity/max_ratio <= 1, because"))));
  const auto verdict = yaml::parse_file(folder / "strict/verdict.yaml");
  EXPECT_FALSE(verdict.find("passed")->as_boolean());
  const Finished alone = robustness(folder, short_scenario(folder), "alone",
                                    {"--sample", "1", "--limit", "joint_velocity/max_ratio<=0.01"});
  EXPECT_EQ(alone.exit_code, 3) << alone.err;
  EXPECT_THAT(alone.out, HasSubstr("Simulation checks: failed: yield, "));
}

TEST(Robustness, WhatIsFinishedIsOnDiskWheneverItIsKilled) {
  const test::TemporaryFolder folder;
  Program running({"robustness", "extended_tuned", "--scenarios", short_scenario(folder), "--out",
                   folder / "out", "--samples", "1000", "--workers", "2"},
                  testing::TempDir());
  const auto rows = [&] {
    const std::string text = test::read_text(folder / "out/samples.csv");
    return std::count(text.begin(), text.end(), '\n') - 1;
  };
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (rows() < 3 && running.running() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ASSERT_GE(rows(), 3);
  ASSERT_TRUE(running.running());
  running.interrupt();
  EXPECT_EQ(running.wait().exit_code, 130);
  EXPECT_GE(rows(), 3);
  EXPECT_LT(rows(), 1000);
}

TEST(Robustness, DrawsArmsFromTheDistributionOfAFileAndSaysSo) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("uncertainty.yaml", test::kSmallDistribution);
  const Finished done =
      robustness(folder, short_scenario(folder), "drawn", {"--samples", "2", "--distribution", file});
  ASSERT_THAT(done.exit_code, testing::AnyOf(0, 3)) << done.err;
  const RunRecord record = find_run_record(folder / "drawn").value();
  ASSERT_TRUE(record.distribution);
  EXPECT_EQ(record.distribution->file, file);
  EXPECT_EQ(record.distribution->drawn.size(), 4U);
  EXPECT_THAT(record.distribution->not_drawn, testing::IsEmpty());
  EXPECT_THAT(record.distribution->not_told, testing::ElementsAre("elbow_joint/viscous_friction"));
  EXPECT_EQ(test::input_in(record, file).hash, hash_of_file(file));
  EXPECT_THAT(test::read_text(folder / "drawn/samples.csv"), HasSubstr("distribution/payload/mass"));
  const auto verdict = yaml::parse_file(folder / "drawn/verdict.yaml");
  EXPECT_THAT(verdict.find("assumes")->as_strings(), testing::Contains(HasSubstr(file)));
}

TEST(Robustness, BadInputEndsWithTwo) {
  const test::TemporaryFolder folder;
  const std::string scenario = short_scenario(folder);
  const auto refused = [&](const char* option, const char* value) {
    return test::refused_command(
        {"robustness", "extended_tuned", "--scenarios", scenario, "--out", folder / "limit", option, value});
  };
  EXPECT_THAT(refused("--mass", "1.5"),
              test::refused_at({.key = "perturbation/mass", .value = "1.5", .limit = "in [0, 1)"}));
  EXPECT_THAT(refused("--limit", "speed<=1"), test::refused_at({.key = "limit", .value = "speed"}));
  const std::string file = folder.write("uncertainty.yaml", test::kSmallDistribution);
  EXPECT_THAT(test::refused_command({"robustness", "extended_tuned", "--scenarios", scenario, "--out",
                                     folder / "limit", "--distribution", file, "--friction", "0.25"}),
              test::refused_at({.key = "perturbation/friction", .value = "0.25"}));
  const std::string wrong = folder.write("wrong.yaml", "parameters: [{name: knee/delay, mean: 0}]\n");
  EXPECT_THAT(refused("--distribution", wrong.c_str()),
              test::refused_at({.file = wrong, .key = "parameters/0/name", .value = "knee/delay"}));
  EXPECT_FALSE(std::filesystem::exists(folder / "limit"));
}

}  // namespace robustness_test
}  // namespace armtune::internal
