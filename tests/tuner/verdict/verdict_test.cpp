#include "tuner/verdict/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim/csv/text_file.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace verdict_verdict_test {

using testing::HasSubstr;
using testing::Not;

Check failed(CheckKind kind, const std::string& scenario, const std::string& joint, double time) {
  return {kind, false, scenario, "", joint, time, 94.25, 56.0, "N m", "a \"quoted\" clause: with, signs"};
}

TEST(SimulationVerdict, WithoutChecksNothingHasPassed) {
  EXPECT_FALSE(SimulationVerdict().passed());
  EXPECT_THAT(to_text(SimulationVerdict()), Not(HasSubstr("passed")));
}

TEST(SimulationVerdict, OneFailureFailsItAndIsNamedWithJointAndTime) {
  SimulationVerdict verdict;
  verdict.checks = {{CheckKind::kCompleted}, {CheckKind::kYield}};
  EXPECT_TRUE(verdict.passed());
  EXPECT_THAT(to_text(verdict), HasSubstr("Simulation checks: passed"));
  verdict.checks.push_back(failed(CheckKind::kEffortLimit, "long", "wrist_1_joint", 527.318));
  EXPECT_FALSE(verdict.passed());
  const std::string text = to_text(verdict);
  EXPECT_THAT(text, HasSubstr("Simulation checks: failed: effort limit, wrist_1_joint, 527.318 s"));
  EXPECT_THAT(text, HasSubstr("long"));
}

TEST(SimulationVerdict, ReadsBackFromItsFileFieldByField) {
  SimulationVerdict verdict;
  for (int kind = 0; kind <= static_cast<int>(CheckKind::kBetterThanStart); ++kind) {
    verdict.checks.push_back({static_cast<CheckKind>(kind)});
    verdict.checks.push_back(failed(static_cast<CheckKind>(kind), "a: b", "joint #1", 0.1 * kind));
    verdict.checks.back().arm = "random arm 2 of 6";
  }
  verdict.not_checked = {"self-collision", "a \\ b"};
  verdict.assumes = {};
  verdict.notes = {"one note"};
  const test::TemporaryFolder folder;
  const std::string path = folder / "verdict.yaml";
  write_text_file(path, verdict_yaml(verdict));
  const SimulationVerdict read = read_verdict(path);
  ASSERT_EQ(read.checks.size(), verdict.checks.size());
  for (std::size_t i = 0; i < read.checks.size(); ++i) {
    const Check& a = read.checks[i];
    const Check& b = verdict.checks[i];
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.passed, b.passed);
    EXPECT_EQ(a.scenario, b.scenario);
    EXPECT_EQ(a.arm, b.arm);
    EXPECT_EQ(a.joint, b.joint);
    EXPECT_EQ(a.unit, b.unit);
    EXPECT_EQ(a.detail, b.detail);
    for (double Check::*number : {&Check::time, &Check::value, &Check::threshold}) {
      EXPECT_TRUE(a.*number == b.*number || (std::isnan(a.*number) && std::isnan(b.*number)));
    }
  }
  EXPECT_EQ(read.not_checked, verdict.not_checked);
  EXPECT_EQ(read.assumes, verdict.assumes);
  EXPECT_EQ(read.notes, verdict.notes);
  EXPECT_EQ(verdict_yaml(read), verdict_yaml(verdict));
}

TEST(SimulationVerdict, AFileWithACheckOfAnotherVersionIsRefusedWithItsLine) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "verdict.yaml";
  write_text_file(path,
                  "passed: true\nchecks:\n  - {check: telepathy, passed: true}\nnot_checked: []\nassumes: "
                  "[]\nnotes: []\n");
  EXPECT_THAT([&] { return read_verdict(path); },
              test::refused_at({.file = path,
                                .line = 3,
                                .key = "checks/0/check",
                                .value = "telepathy",
                                .limit = HasSubstr(name(CheckKind::kBetterThanStart))}));
}

}  // namespace verdict_verdict_test
}  // namespace armtune::internal
