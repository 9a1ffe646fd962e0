// Tables on a terminal of 80 columns.

#include <gtest/gtest.h>

#include <sstream>

#include "tests/cli/support/program.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace tables_test {

using test::run_program;

/// Whether a line is a row of a table: at least three gaps of two blanks or more, behind its first word.
bool is_row(const std::string& line) {
  int gaps = 0;
  for (std::size_t at = line.find_first_not_of(' '); (at = line.find("  ", at)) != std::string::npos;) {
    at = line.find_first_not_of(' ', at);
    if (at == std::string::npos) break;
    ++gaps;
  }
  return gaps >= 3;
}

void expect_narrow(const std::string& out, int rows) {
  std::istringstream lines(out);
  int found = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!is_row(line)) continue;
    ++found;
    EXPECT_LE(line.size(), 80U) << line;
  }
  EXPECT_GE(found, rows) << "or there is no table here\n" << out;
}

TEST(Tables, FitEightyColumns) {
  const test::ShortStudy study;
  expect_narrow(run_program({"robot", "ur10"}).out, 14);
  expect_narrow(run_program({"robot"}).out, 11);
  const std::string run = study / "run";
  const test::Finished tuned = run_program({"tune", study.path(), "--out", run});
  ASSERT_EQ(tuned.exit_code, 0) << tuned.err;
  expect_narrow(tuned.out, 12);
  expect_narrow(run_program({"compare", run + "/start", run, "--out", study / "compared"}).out, 5);
  expect_narrow(run_program({"robustness", run, "--scenarios", study / "short.yaml", "--samples", "2",
                             "--out", study / "arms"})
                    .out,
                4);
}

}  // namespace tables_test
}  // namespace armtune::internal
