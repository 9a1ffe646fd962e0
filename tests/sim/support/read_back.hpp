#pragma once
// A CSV text read back and compared with what was in memory: every cell, to the bit.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/common/message_text.hpp"
#include "sim/csv/csv_table.hpp"

namespace armtune::internal::test {

/// Numbers that a writer who rounds or a reader who guesses gets wrong.
inline const std::vector<double>& awkward_numbers() {
  static const std::vector<double> numbers = {1.0 / 3.0,
                                              -0.0,
                                              5e-324,
                                              1e300,
                                              0.1 + 0.2,
                                              -std::numeric_limits<double>::max(),
                                              std::nextafter(1.0, 2.0),
                                              123456789.123456789,
                                              -2.2250738585072014e-308};
  return numbers;
}
inline double awkward(std::size_t i) {
  return awkward_numbers()[i % awkward_numbers().size()];
}

/// What there is no figure for.
inline const std::vector<double>& no_figures() {
  static const std::vector<double> numbers = {NAN, -NAN, INFINITY, -INFINITY};
  return numbers;
}

inline const std::string kAwkwardText = "a, \"b\" = c";
inline const std::string kFormula = "=1+1, \"x\"";

class ReadBack {
 public:
  explicit ReadBack(const std::string& text)
      : table_(CsvTable::parse(text, "written.csv")), seen_(table_.rows() * table_.header().size(), false) {}

  const CsvTable& table() const { return table_; }

  /// The cell holds the very bits, or is empty where there is no figure.
  void number(std::size_t row, const std::string& column, double expected) {
    if (!std::isfinite(expected)) {
      text(row, column, "");
      return;
    }
    const std::size_t place = see(row, column);
    if (place == kNowhere) return;
    EXPECT_NE(table_.text(row, place), "") << column << ", row " << row;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(table_.number(row, place)), std::bit_cast<std::uint64_t>(expected))
        << column << ", row " << row << ": " << table_.text(row, place) << " for " << expected;
  }
  /// The cell is the text, behind an apostrophe where a spreadsheet would take it for a formula.
  void text(std::size_t row, const std::string& column, const std::string& expected) {
    const std::size_t place = see(row, column);
    if (place == kNowhere) return;
    EXPECT_EQ(table_.text(row, place), is_formula(expected) ? "'" + expected : expected)
        << column << ", row " << row;
  }
  /// No cell was left out.
  void expect_all_seen(std::size_t rows) const {
    EXPECT_EQ(table_.rows(), rows);
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      EXPECT_TRUE(seen_[i]) << table_.header()[i % table_.header().size()] << ", row "
                            << i / table_.header().size() << " was compared with nothing";
    }
  }

 private:
  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

  std::size_t see(std::size_t row, const std::string& column) {
    const auto place = table_.find(column);
    if (!place || row >= table_.rows()) {
      ADD_FAILURE() << "no cell in column " << column << ", row " << row;
      return kNowhere;
    }
    seen_[row * table_.header().size() + *place] = true;
    return *place;
  }

  CsvTable table_;
  std::vector<bool> seen_;
};

}  // namespace armtune::internal::test
