#include "tuner/report/series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace armtune::internal::report {
namespace series_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Series, IsHalfAStepOffAtMostAndExactAtItsEnds) {
  std::mt19937_64 random(3);
  for (const double scale : {1e-9, 1.0, 1e6}) {
    std::uniform_real_distribution<double> draw(-scale, 3.0 * scale);
    std::vector<double> values;
    for (int i = 0; i < 2000; ++i) values.push_back(draw(random));
    const Series series = quantize(values);
    ASSERT_EQ(series.steps.size(), values.size());
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    EXPECT_EQ(series.lo, *low);
    EXPECT_EQ(series.hi, *high);
    EXPECT_EQ(series.at(static_cast<std::size_t>(low - values.begin())), *low);
    EXPECT_EQ(series.at(static_cast<std::size_t>(high - values.begin())), *high);
    // Half a step, and a little for the rounding of the arithmetic around it.
    const double half_step = (series.hi - series.lo) / Series::kSteps / 2.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_LE(std::abs(series.at(i) - values[i]), half_step * (1.0 + 1e-9)) << i;
    }
  }
}

TEST(Series, KeepsTheOrderOfValues) {
  std::vector<double> values;
  for (int i = 0; i < 500; ++i) values.push_back(std::exp(0.02 * i));
  const Series series = quantize(values);
  EXPECT_TRUE(std::is_sorted(series.steps.begin(), series.steps.end()));
}

TEST(Series, SaysWhereThereIsNoValue) {
  const std::vector<double> values = {1.0, NAN, kInfinity, 2.0, -kInfinity};
  const Series series = quantize(values);
  EXPECT_EQ(series.lo, 1.0);
  EXPECT_EQ(series.hi, 2.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(std::isnan(series.at(i)), !std::isfinite(values[i])) << i;
    EXPECT_EQ(series.steps[i] == Series::kNoValue, !std::isfinite(values[i])) << i;
  }
  const Series none = quantize(std::vector<double>{NAN, NAN});
  EXPECT_EQ(none.lo, 0.0);
  EXPECT_EQ(none.hi, 0.0);
  EXPECT_TRUE(std::isnan(none.at(1)));
  EXPECT_TRUE(quantize({}).steps.empty());
}

TEST(Series, HoldsConstantsAndTheWidestRangeThereIs) {
  const Series constant = quantize(std::vector<double>{0.3, 0.3, 0.3});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(constant.at(i), 0.3);
  const double most = std::numeric_limits<double>::max();
  const Series wide = quantize(std::vector<double>{-most, 0.0, most});
  EXPECT_EQ(wide.at(0), -most);
  EXPECT_EQ(wide.at(2), most);
  EXPECT_LT(std::abs(wide.at(1)), most / Series::kSteps);
}

}  // namespace series_test
}  // namespace armtune::internal::report
