// Long CSV files of numbers, read block by block, against the reader of whole files.

#include "sim/csv/number_table.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace number_table_test {

using test::refused_at;
using test::TemporaryFolder;

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
  EXPECT_THAT([&] { some.column("time"); }, refused_at({.file = path, .key = "time"}));
}

TEST(NumberTable, LeavesOutARowThatWasBeingWritten) {
  const TemporaryFolder folder;
  EXPECT_EQ(NumberTable::read(folder.write("a.csv", "a,b\n1,2\n3,"), all).rows(), 1U);
  EXPECT_EQ(NumberTable::read(folder.write("a.csv", "a,b\n1,2\n\"3,4\n5,6"), all).rows(), 1U);
  EXPECT_EQ(NumberTable::read(folder.write("a.csv", "a,b\n"), all).rows(), 0U);
}

TEST(NumberTable, RefusesWithTheLine) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.csv";
  const auto refusal = [&](const std::string& text) {
    folder.write("a.csv", text);
    return test::input_error([&] { NumberTable::read(path, all); });
  };
  EXPECT_THAT(refusal("a,b\n1,2\n1,x\n"),
              refused_at({.file = path, .line = 3, .key = "b", .value = "x", .limit = "a number"}));
  EXPECT_THAT(refusal("a,b\n1,2\n1\n"), refused_at({.line = 3, .value = "1", .limit = "2 cells"}));
  EXPECT_THAT(refusal("a,a\n1,2\n"), refused_at({.line = 1, .key = "a"}));
  EXPECT_THAT(refusal(""), refused_at({.file = path, .line = 0}));
  EXPECT_THAT(refusal("a,b\n1," + std::string(20 << 20, '1')),
              refused_at({.line = 2, .limit = "at most 16 MB"}));
  EXPECT_THAT([&] { NumberTable::read(folder / "none.csv", all); },
              refused_at({.file = folder / "none.csv"}));
}

}  // namespace number_table_test
}  // namespace armtune::internal
