#include "sim/csv/cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/read_back.hpp"

namespace armtune::internal {
namespace cell_test {

TEST(Cell, ANumberReadsBackToTheSameBitsAndNoValueIsEmpty) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  for (int i = 0; i < 1000; ++i) {
    const double value = (i % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, exponent(generator));
    EXPECT_EQ(std::stod(cell(value)), value);
  }
  EXPECT_EQ(cell(NAN), "");
}

TEST(Cell, ReadsBackToTheBitAndIsEmptyForWhatIsNotFinite) {
  for (const double value : test::awkward_numbers()) {
    test::ReadBack read("a,b\n" + cell(value) + ",x\n");
    read.number(0, "a", value);
  }
  for (const double value : test::no_figures()) EXPECT_EQ(cell(value), "") << value;
}

TEST(Cell, ATextReadsBackWhateverIsInIt) {
  EXPECT_EQ(cell(std::string("velocity of elbow_joint")), "velocity of elbow_joint");
  for (const std::string text : {"a, b", "say \"it\"", "\"", ",", ""}) {
    const test::Csv csv("first,second\n" + cell(text) + ",x\n");
    ASSERT_EQ(csv.rows.size(), 1U);
    EXPECT_EQ(csv.at(0, "first"), text);
    EXPECT_EQ(csv.at(0, "second"), "x");
  }
}

TEST(Cell, IsNoFormulaToASpreadsheet) {
  for (const std::string text : {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "=HYPERLINK(\"a\",\"b\")"}) {
    EXPECT_EQ(cell(text).find_first_of("=+-@\t"), cell(text).find('\'') + 1) << text;
    EXPECT_TRUE(cell(text).starts_with("'") || cell(text).starts_with("\"'")) << text;
  }
  EXPECT_EQ(cell("a=1"), "a=1");
  EXPECT_EQ(cell(-1.0), "-1") << "numbers stay numbers";
}

}  // namespace cell_test
}  // namespace armtune::internal
