// Long CSV files of numbers, read block by block, against the reader of whole files.

#include "sim/csv/number_table.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

bool all(std::string_view) {
  return true;
}

TEST(NumberTable, HasTheNumbersOfTheWholeFileAcrossItsBlocks) {
  const TemporaryFolder folder;
  std::string text = "\xEF\xBB\xBFtime,\"a,b\",c\r\n";
  for (int r = 0; r < 200'000; ++r)  // 5 MB, in blocks of 1 MB
    text += fmt::format("{},{},\"{}\"\n", r, r % 7 == 0 ? "" : fmt::format("{}", std::sqrt(r)), -r);
  const std::string path = folder.write("long.csv", text);
  const CsvTable whole = CsvTable::read(path);
  const NumberTable table = NumberTable::read(path, all);
  ASSERT_EQ(table.rows(), whole.rows());
  EXPECT_EQ(table.header(), whole.header());
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t r = 0; r < table.rows(); ++r) {
      const double expected = whole.number(r, c);
      ASSERT_TRUE(table.number(r, c) == expected || (std::isnan(table.number(r, c)) && std::isnan(expected)))
          << r;
    }
  }
  const NumberTable some = NumberTable::read(path, [](std::string_view name) { return name == "c"; });
  EXPECT_EQ(some.header(), std::vector<std::string>{"c"});
  EXPECT_EQ(some.numbers(0), table.numbers(2));
  EXPECT_THAT(test::refusal([&] { some.column("time"); }), HasSubstr("long.csv"));
}

TEST(NumberTable, LeavesOutARowThatWasBeingWritten) {
  const TemporaryFolder folder;
  EXPECT_EQ(NumberTable::read(folder.write("a.csv", "a,b\n1,2\n3,"), all).rows(), 1U);
  EXPECT_EQ(NumberTable::read(folder.write("a.csv", "a,b\n1,2\n\"3,4\n5,6"), all).rows(), 1U);
  EXPECT_EQ(NumberTable::read(folder.write("a.csv", "a,b\n"), all).rows(), 0U);
}

TEST(NumberTable, RefusesWithTheLine) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& text) {
    const std::string path = folder.write("a.csv", text);
    return test::refusal([&] { NumberTable::read(path, all); });
  };
  EXPECT_THAT(refusal("a,b\n1,2\n1,x\n"), testing::AllOf(HasSubstr("a.csv:3"), HasSubstr("b")));
  EXPECT_THAT(refusal("a,b\n1,2\n1\n"), HasSubstr("a.csv:3"));
  EXPECT_THAT(refusal("a,a\n1,2\n"), HasSubstr("a.csv:1"));
  EXPECT_THAT(refusal(""), HasSubstr("a.csv"));
  EXPECT_THAT(refusal("a,b\n1," + std::string(20 << 20, '1')), HasSubstr("a.csv:2"));
  EXPECT_THAT(test::refusal([&] { NumberTable::read(folder / "none.csv", all); }), HasSubstr("none.csv"));
}

}  // namespace
}  // namespace armtune::internal
