#include "sim/csv/csv_table.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/rollout/error_report.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace csv_table_test {

using test::refusal;
using test::refused_at;

TEST(CsvTable, ReadsWhatErrorsCsvWrites) {
  std::vector<ScenarioResult> results(2);
  for (std::size_t s = 0; s < 2; ++s) {
    results[s].scenario = s == 0 ? "first" : "second";
    results[s].result.metrics.max_ratio_joint = "elbow";
    for (std::size_t m = 0; m < kMetricCount; ++m) {
      results[s].result.metrics.value[m] =
          (m + s) % 3 == 0 ? NAN : std::sin(static_cast<double>(m + 40 * s)) * 1e-5;
    }
  }
  const CsvTable table = CsvTable::parse(errors_csv(results), "errors.csv");
  ASSERT_EQ(table.rows(), 2U);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(table.text(s, table.column("scenario")), results[s].scenario);
    EXPECT_EQ(table.text(s, table.column("joint_velocity/max_ratio_joint")), "elbow");
    for (const Metric metric : all_metrics()) {
      const double expected = results[s].result.metrics[metric];
      const double read = table.number(s, table.column(name(metric)));
      EXPECT_TRUE(read == expected || (std::isnan(read) && std::isnan(expected))) << name(metric);
    }
  }
}

TEST(CsvTable, TakesQuotesOffAndKeepsWhatTheyGuard) {
  const CsvTable table = CsvTable::parse("a,b\n\"x, y\",1\n\"say \"\"no\"\"\nthen\",2\n,\"3\"\n", "t");
  ASSERT_EQ(table.rows(), 3U);
  EXPECT_EQ(table.text(0, 0), "x, y");
  EXPECT_EQ(table.text(1, 0), "say \"no\"\nthen");
  EXPECT_EQ(table.text(2, 0), "");
  EXPECT_THAT(table.numbers(1), testing::ElementsAre(1.0, 2.0, 3.0));
}

TEST(CsvTable, LeavesOutTheLastRowOfARunThatWasKilled) {
  const CsvTable table = CsvTable::parse("a,b\n1,2\n3,", "t");
  EXPECT_EQ(table.rows(), 1U);
  EXPECT_EQ(table.number(0, 1), 2.0);
  EXPECT_EQ(CsvTable::parse("a,b\n", "t").rows(), 0U);
}

TEST(CsvTable, TakesTheLastRowOfAUsersFileWithoutItsLineEnd) {
  const CsvTable table = CsvTable::parse("a,b\n1,2\n3,4", "t", CsvOrigin::kUser);
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.number(1, 1), 4.0);
  EXPECT_EQ(CsvTable::parse("a,b\n1,2\n3,", "t", CsvOrigin::kUser).rows(), 2U);
  EXPECT_THAT([] { CsvTable::parse("a,b\n1,2\n3", "t.csv", CsvOrigin::kUser); },
              refused_at({.file = "t.csv", .line = 3, .value = "1", .limit = "2 cells"}));
}

TEST(CsvTable, SkipsAByteOrderMark) {
  EXPECT_EQ(CsvTable::parse("\xEF\xBB\xBFtime\n1\n", "t").column("time"), 0U);
}

TEST(CsvTable, RefusesAQuoteThatIsNeverClosed) {
  for (const CsvOrigin origin : {CsvOrigin::kUser, CsvOrigin::kArmtune}) {
    EXPECT_THAT([&] { CsvTable::parse("a,\"b\n1,2\n", "t.csv", origin); },
                refused_at({.file = "t.csv", .line = 1}));
  }
  EXPECT_EQ(refusal([] { CsvTable::parse("a,b\n1,2\n\"3,4\n5,6\n", "t.csv", CsvOrigin::kUser); }),
            "t.csv:3: the quote opened here is never closed; close it, or double it if it is part of the "
            "text");
}

TEST(CsvTable, ErrorsHaveFileLineColumnValueAndLimitAsFields) {
  const auto read = [] { CsvTable::parse("a,b\n1,2\n1,x7\n", "t.csv").numbers(1); };
  EXPECT_THAT(read, refused_at({.file = "t.csv", .line = 3, .key = "b", .value = "x7", .limit = "a number"}));
  EXPECT_EQ(refusal(read), "t.csv:3: 'x7' in column b is not a number");
}

TEST(CsvTable, RefusesTwoColumnsOfOneNameAndTooMany) {
  EXPECT_THAT([] { CsvTable::parse("a,b,a\n1,2,3\n", "t.csv"); },
              refused_at({.file = "t.csv", .line = 1, .key = "a", .limit = "one column of each name"}));
  std::string header = "c0";
  for (int i = 1; i <= 10'000; ++i) header += fmt::format(",c{}", i);
  EXPECT_THAT([&] { CsvTable::parse(header + "\n", "t.csv"); },
              refused_at({.file = "t.csv", .line = 1, .limit = "at most 10000 columns"}));
}

TEST(CsvTable, RefusesFilesThatAreNone) {
  EXPECT_THAT([] { CsvTable::read("/tmp"); }, refused_at({.file = "/tmp", .limit = "a CSV file"}));
  EXPECT_THAT([] { CsvTable::read("/dev/zero", CsvOrigin::kUser); },
              refused_at({.file = "/dev/zero", .limit = "at most 48 MB"}));
}

TEST(CsvTable, RefusesMoreCellsThanMemoryShouldHold) {
  const std::string rows(24'000'001, '\n');
  EXPECT_THAT([&] { CsvTable::parse("a\n" + rows, "t.csv"); },
              refused_at({.file = "t.csv", .line = 0, .limit = "at most 24000000 cells"}));
}

TEST(CsvTable, NamesFileLineAndColumnOfWhatIsWrong) {
  EXPECT_THAT([] { CsvTable::parse("a,b\n1,2\n1,2,3\n", "t.csv"); },
              refused_at({.file = "t.csv", .line = 3, .value = "3", .limit = "2 cells"}));
  const auto find_time = [] { CsvTable::parse("times,b\n", "t.csv").column("time"); };
  EXPECT_THAT(find_time, refused_at({.file = "t.csv", .line = 1, .key = "time", .limit = "a column 'time'"}));
  EXPECT_EQ(refusal(find_time), "t.csv:1: no column 'time' (did you mean 'times'?)");
  EXPECT_THAT([] { CsvTable::parse("", "t.csv"); }, refused_at({.file = "t.csv"}));
  EXPECT_THAT([] { CsvTable::read("/nonexistent/t.csv"); }, refused_at({.file = "/nonexistent/t.csv"}));
}

}  // namespace csv_table_test
}  // namespace armtune::internal
