#include "tuner/report/buckets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace armtune::internal::report {
namespace buckets_test {

/// Noise with gaps: every `gap`-th value is missing, one in three of these infinite.
std::vector<double> noisy(std::size_t rows, std::size_t gap, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> draw;
  std::vector<double> values;
  for (std::size_t i = 0; i < rows; ++i) {
    values.push_back(draw(random));
    if (gap > 0 && i % gap == 0) values.back() = i % 3 == 0 ? INFINITY : NAN;
  }
  return values;
}

TEST(Buckets, KeepTheSmallestAndTheLargestOfEveryBucketInTheirOrder) {
  for (const std::size_t rows : {41U, 1000U, 4003U}) {
    for (const std::size_t most : {1U, 7U, 20U}) {
      for (const std::size_t gap : {0U, 1U, 2U, 5U}) {
        const Buckets buckets(rows, most);
        ASSERT_FALSE(buckets.whole());
        const auto values = noisy(rows, gap, static_cast<unsigned>(rows + most + gap));
        const auto kept = buckets.extremes(values);
        ASSERT_EQ(kept.size(), 2 * most);
        for (std::size_t b = 0; b < most; ++b) {
          // By sorting positions rather than by one pass.
          std::vector<std::size_t> finite;
          for (std::size_t r = buckets.first_row(b); r < buckets.first_row(b + 1); ++r) {
            if (std::isfinite(values[r])) finite.push_back(r);
          }
          const double first = kept[2 * b];
          const double second = kept[2 * b + 1];
          if (finite.empty()) {
            EXPECT_TRUE(std::isnan(first) && std::isnan(second));
            continue;
          }
          std::sort(finite.begin(), finite.end(),
                    [&](std::size_t i, std::size_t k) { return values[i] < values[k]; });
          EXPECT_EQ(std::min(first, second), values[finite.front()]);
          EXPECT_EQ(std::max(first, second), values[finite.back()]);
          EXPECT_EQ(first < second, finite.front() < finite.back() && finite.size() > 1)
              << "whichever came first stands first";
        }
      }
    }
  }
}

TEST(Buckets, CoverEveryRowOnceAndAreOfEqualLength) {
  for (const std::size_t rows : {9U, 100U, 4001U}) {
    const std::size_t most = 4;
    const Buckets buckets(rows, most);
    EXPECT_EQ(buckets.first_row(0), 0U);
    EXPECT_EQ(buckets.first_row(most), rows);
    for (std::size_t b = 0; b < most; ++b) {
      const std::size_t length = buckets.first_row(b + 1) - buckets.first_row(b);
      EXPECT_GE(length, rows / most);
      EXPECT_LE(length, rows / most + 1);
    }
  }
}

TEST(Buckets, HaveTimesThatRiseAndLieInThem) {
  const std::size_t rows = 1234;
  const std::size_t most = 50;
  std::vector<double> time;
  for (std::size_t i = 0; i < rows; ++i) time.push_back(0.01 * static_cast<double>(i));
  const Buckets buckets(rows, most);
  const auto kept = buckets.times(time);
  ASSERT_EQ(kept.size(), buckets.points());
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  for (std::size_t b = 0; b < most; ++b) {
    EXPECT_EQ(kept[2 * b], time[buckets.first_row(b)]);
    EXPECT_GT(kept[2 * b + 1], kept[2 * b]);
    EXPECT_LE(kept[2 * b + 1], time[buckets.first_row(b + 1) - 1]);
  }
}

TEST(Buckets, KeepAShortRunWhole) {
  const auto values = noisy(40, 0, 9);
  for (const std::size_t most : {20U, 21U, 700U}) {
    const Buckets buckets(values.size(), most);
    EXPECT_TRUE(buckets.whole());
    EXPECT_EQ(buckets.extremes(values), values);
    EXPECT_EQ(buckets.times(values), values);
    EXPECT_EQ(buckets.points(), values.size());
  }
  EXPECT_FALSE(Buckets(41, 20).whole());
  EXPECT_TRUE(Buckets(0, 1).extremes({}).empty());
}

}  // namespace buckets_test
}  // namespace armtune::internal::report
