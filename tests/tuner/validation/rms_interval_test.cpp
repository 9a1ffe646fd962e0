#include "tuner/validation/rms_interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace armtune::internal {
namespace rms_interval_test {

TEST(RmsInterval, IsAroundTheRootOfTheMeanSquare) {
  const std::vector<double> squares = {1.0, 4.0, 9.0, 2.0, 8.0, 0.0, 3.0};
  const RmsInterval found = rms_interval(squares);
  EXPECT_DOUBLE_EQ(found.rms, std::sqrt(27.0 / 7.0));
  EXPECT_NEAR(found.low * found.high, found.rms * found.rms, 1e-12) << "symmetric in the logarithm";
  EXPECT_LT(found.low, found.rms);
}

TEST(RmsInterval, ScalesWithTheErrors) {
  std::vector<double> squares = {1.0, 4.0, 9.0, 2.0, 8.0, 0.0, 3.0, 5.0, 6.0, 1.0, 2.0, 9.0};
  const RmsInterval found = rms_interval(squares);
  for (double& x : squares) x *= 9.0;
  const RmsInterval scaled = rms_interval(squares);
  EXPECT_NEAR(scaled.rms, 3.0 * found.rms, 1e-12);
  EXPECT_NEAR(scaled.low, 3.0 * found.low, 1e-12);
  EXPECT_NEAR(scaled.high, 3.0 * found.high, 1e-12);
}

TEST(RmsInterval, IsUnknownForFewErrorsAndAPointForEqualOnes) {
  EXPECT_TRUE(std::isnan(rms_interval({}).rms));
  EXPECT_DOUBLE_EQ(rms_interval({4.0, 4.0}).rms, 2.0);
  EXPECT_TRUE(std::isnan(rms_interval({4.0, 4.0}).low));
  const RmsInterval equal = rms_interval(std::vector<double>(50, 4.0));
  EXPECT_DOUBLE_EQ(equal.low, 2.0);
  EXPECT_DOUBLE_EQ(equal.high, 2.0);
  EXPECT_DOUBLE_EQ(rms_interval(std::vector<double>(50, 0.0)).high, 0.0);
}

/// Errors of windows that overlap by half: each shares half of its causes with the next one.
TEST(RmsInterval, CoversTheTruthInAboutNineteenOfTwentySets) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  constexpr int kSets = 3000;
  for (const int count : {8, 20, 40, 200}) {
    int covered = 0;
    for (int set = 0; set < kSets; ++set) {
      std::vector<double> squares;
      double last = normal(generator);
      for (int i = 0; i < count; ++i) {
        const double next = normal(generator);
        squares.push_back(0.5 * (last + next) * (last + next));  // of variance 1
        last = next;
      }
      const RmsInterval found = rms_interval(squares);
      covered += found.low <= 1.0 && 1.0 <= found.high ? 1 : 0;
    }
    // The standard deviation of the share is 0.004. Batches of four still depend on each other a little.
    EXPECT_GT(covered, 0.90 * kSets) << count;
    EXPECT_LT(covered, 0.98 * kSets) << count;
  }
}

}  // namespace rms_interval_test
}  // namespace armtune::internal
