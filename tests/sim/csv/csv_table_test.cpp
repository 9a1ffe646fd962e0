#include "sim/csv/csv_table.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/rollout/error_report.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace {

using test::refusal;
using testing::HasSubstr;

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
  EXPECT_THAT(refusal([] { CsvTable::parse("a,b\n1,2\n3", "t.csv", CsvOrigin::kUser); }),
              HasSubstr("t.csv:3: the row has 1 cells, but the header has 2"));
}

TEST(CsvTable, SkipsAByteOrderMark) {
  EXPECT_EQ(CsvTable::parse("\xEF\xBB\xBFtime\n1\n", "t").column("time"), 0U);
}

TEST(CsvTable, RefusesAQuoteThatIsNeverClosed) {
  for (const CsvOrigin origin : {CsvOrigin::kUser, CsvOrigin::kArmtune}) {
    EXPECT_THAT(refusal([&] { CsvTable::parse("a,\"b\n1,2\n", "t.csv", origin); }),
                HasSubstr("t.csv:1: the quote"));
  }
  EXPECT_THAT(refusal([] { CsvTable::parse("a,b\n1,2\n\"3,4\n5,6\n", "t.csv", CsvOrigin::kUser); }),
              HasSubstr("t.csv:3: the quote"));
}

TEST(CsvTable, ErrorsHaveFileLineAndColumnAsFields) {
  try {
    CsvTable::parse("a,b\n1,2\n1,x7\n", "t.csv").numbers(1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place().file, "t.csv");
    EXPECT_EQ(error.place().line, 3);
    EXPECT_EQ(error.place().key, "b");
  }
}

TEST(CsvTable, RefusesTwoColumnsOfOneNameAndTooMany) {
  EXPECT_THAT(refusal([] { CsvTable::parse("a,b,a\n1,2,3\n", "t.csv"); }),
              HasSubstr("t.csv:1: two columns are called 'a'"));
  std::string header = "c0";
  for (int i = 1; i <= 10'000; ++i) header += fmt::format(",c{}", i);
  EXPECT_THAT(refusal([&] { CsvTable::parse(header + "\n", "t.csv"); }),
              HasSubstr("more than 10000 columns"));
}

TEST(CsvTable, RefusesFilesThatAreNone) {
  EXPECT_THAT(refusal([] { CsvTable::read("/tmp"); }),
              HasSubstr("/tmp: is a directory; expected a CSV file"));
  EXPECT_THAT(refusal([] { CsvTable::read("/dev/zero", CsvOrigin::kUser); }), HasSubstr("larger than 48 MB"));
}

TEST(CsvTable, RefusesMoreCellsThanMemoryShouldHold) {
  const std::string rows(24'000'001, '\n');
  EXPECT_THAT(refusal([&] { CsvTable::parse("a\n" + rows, "t.csv"); }),
              testing::AllOf(HasSubstr("t.csv: more than 24000000 cells"), HasSubstr("smaller file")));
}

TEST(CsvTable, NamesFileLineAndColumnOfWhatIsWrong) {
  EXPECT_THAT(refusal([] { CsvTable::parse("a,b\n1,2\n1,2,3\n", "t.csv"); }),
              HasSubstr("t.csv:3: the row has 3 cells"));
  EXPECT_THAT(refusal([] { CsvTable::parse("a,b\n1,2\n1,x7\n", "t.csv").numbers(1); }),
              testing::AllOf(HasSubstr("t.csv:3"), HasSubstr("x7"), HasSubstr("column b")));
  EXPECT_THAT(refusal([] { CsvTable::parse("times,b\n", "t.csv").column("time"); }),
              HasSubstr("t.csv:1: no column 'time' (did you mean 'times'?)"));
  EXPECT_THAT(refusal([] { CsvTable::parse("", "t.csv"); }), HasSubstr("t.csv"));
  EXPECT_THAT(refusal([] { CsvTable::read("/nonexistent/t.csv"); }),
              HasSubstr("/nonexistent/t.csv: no such file"));
}

}  // namespace
}  // namespace armtune::internal
