#include "tuner/samples/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace armtune::internal {
namespace statistics_test {

TEST(Quantile, IsExactAtTheValuesAndLinearBetween) {
  const std::vector<double> values = {1.0, 2.0, 4.0, 8.0, 16.0};
  EXPECT_EQ(quantile(values, 0.0), 1.0);
  EXPECT_EQ(quantile(values, 0.25), 2.0);
  EXPECT_EQ(quantile(values, 0.5), 4.0);
  EXPECT_EQ(quantile(values, 1.0), 16.0);
  EXPECT_DOUBLE_EQ(quantile(values, 0.875), 12.0);
  EXPECT_EQ(quantile(std::vector<double>{3.0}, 0.7), 3.0);
}

TEST(ConditionalValueAtRisk, IsTheMeanOfTheWorstShare) {
  const std::vector<double> values = {1.0, 2.0, 3.0, 4.0};
  EXPECT_DOUBLE_EQ(conditional_value_at_risk(values, 0.0), 2.5);  // the mean of all
  EXPECT_DOUBLE_EQ(conditional_value_at_risk(values, 0.5), 3.5);
  EXPECT_DOUBLE_EQ(conditional_value_at_risk(values, 0.75), 4.0);
  EXPECT_DOUBLE_EQ(conditional_value_at_risk(values, 0.99), 4.0);                 // never beyond the worst
  EXPECT_DOUBLE_EQ(conditional_value_at_risk(values, 0.625), (4.0 + 1.5) / 1.5);  // half of the 3 counts
}

TEST(ConditionalValueAtRisk, LiesBetweenTheQuantileAndTheWorst) {
  std::mt19937 generator(11);
  std::normal_distribution<double> normal;
  std::vector<double> values(1001);
  for (double& v : values) v = normal(generator);
  std::sort(values.begin(), values.end());
  for (const double p : {0.1, 0.5, 0.9, 0.99}) {
    EXPECT_GT(conditional_value_at_risk(values, p), quantile(values, p));
    EXPECT_LT(conditional_value_at_risk(values, p), values.back());
  }
}

TEST(WilsonInterval, SolvesItsOwnEquation) {
  // Its ends are the probabilities p0 that lie z standard deviations of their own from what was seen.
  constexpr double z = 1.959963984540054;
  for (const std::size_t n : {10U, 1000U}) {
    for (const std::size_t k : {std::size_t{0}, n / 3, n - 1, n}) {
      const double seen = static_cast<double>(k) / static_cast<double>(n);
      const auto [low, high] = wilson_interval(k, n);
      EXPECT_LE(low, seen);
      EXPECT_GE(high, seen);
      for (const double p0 : {low, high}) {
        if (p0 <= 0.0 || p0 >= 1.0) continue;
        EXPECT_NEAR(std::abs(seen - p0), z * std::sqrt(p0 * (1.0 - p0) / static_cast<double>(n)), 1e-12);
      }
    }
  }
}

TEST(WilsonInterval, HoldsTheTruthAsOftenAsItSays) {
  std::mt19937 generator(12);
  constexpr int kRepeats = 4000;
  int held = 0;
  for (int i = 0; i < kRepeats; ++i) {
    std::binomial_distribution<int> draw(1000, 0.97);
    const auto [low, high] = wilson_interval(static_cast<std::size_t>(draw(generator)), 1000);
    held += low <= 0.97 && 0.97 <= high ? 1 : 0;
  }
  // Binomial coverage steps about 95 % by some percent; 4000 repeats know it within 1.4 % (four deviations).
  EXPECT_NEAR(static_cast<double>(held) / kRepeats, 0.95, 0.025);
}

}  // namespace statistics_test
}  // namespace armtune::internal
