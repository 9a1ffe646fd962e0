#include "tuner/derivatives/peak_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace armtune::internal {
namespace peak_rows_test {

/// A series of one channel in periods of 10 ms.
struct OneSeries {
  explicit OneSeries(std::vector<double> values) {
    rollout.start = 2.0;
    rollout.period = 0.01;
    series.values = std::move(values);
  }
  std::vector<SampleRow> rows(const DerivativeOptions& options,
                              SeriesKind kind = SeriesKind::kLargest) const {
    return peak_rows(rollout, series, kind, options);
  }
  RolloutSeries rollout;
  MetricSeries series;
};

/// Windows of two periods.
DerivativeOptions options_with(double band, std::size_t most_rows) {
  DerivativeOptions options;
  options.band = band;
  options.spacing = 0.02;
  options.most_rows = most_rows;
  return options;
}

TEST(PeakRows, AreTheMostExtremeSampleOfEachWindowInTheBand) {
  const OneSeries one({NAN, 0.0, 5.0, 9.0, 10.0, 8.0, 2.0, 7.0});
  const auto rows = one.rows(options_with(0.3, 9));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].value, 10.0);
  EXPECT_EQ(rows[0].period, 4U);
  EXPECT_DOUBLE_EQ(rows[0].time, 2.04);
  EXPECT_EQ(rows[1].value, 9.0);
  EXPECT_EQ(rows[2].value, 7.0);
}

TEST(PeakRows, OfASmallestValueAreTheSmallOnes) {
  const OneSeries one({5.0, 5.0, -1.0, 4.0, 0.0, 5.0, 9.0, 9.0});
  const auto rows = one.rows(options_with(0.2, 9), SeriesKind::kSmallest);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].value, -1.0);
  EXPECT_EQ(rows[1].value, 0.0);
}

TEST(PeakRows, KeepOtherPeaksBeforeTheFlanksOfTheHighest) {
  const OneSeries one({9.6, 9.7, 9.8, 9.9, 10.0, 9.0, 1.0, 0.0, 8.0, 7.5, 0.0, 0.0});
  const auto rows = one.rows(options_with(0.3, 2));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].value, 10.0);
  EXPECT_EQ(rows[1].value, 8.0);
}

TEST(PeakRows, OfJointsAreChosenForEachJoint) {
  OneSeries one({1.0, 9.0, 2.0, 9.5, 10.0, 0.0, 3.0, 0.0});
  one.series.channels = 2;
  const auto rows = one.rows(options_with(0.15, 9));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].channel, 0);
  EXPECT_EQ(rows[0].period, 2U);
  EXPECT_EQ(rows[1].channel, 1);
  EXPECT_EQ(rows[1].period, 1U);
}

TEST(PeakRows, OfASeriesWithoutValuesAreNone) {
  EXPECT_TRUE(OneSeries({NAN, NAN}).rows(options_with(1.0, 9)).empty());
  EXPECT_TRUE(OneSeries({}).rows(options_with(1.0, 9)).empty());
}

}  // namespace peak_rows_test
}  // namespace armtune::internal
