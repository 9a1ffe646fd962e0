#include "tuner/solver/starts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace armtune::internal {
namespace starts_test {

SolverProblem box(std::size_t n) {
  SolverProblem problem;
  problem.start.assign(n, 0.5);
  return problem;
}

TEST(Starts, FillTheBoxOfTheProblemAndNothingElse) {
  SolverProblem problem = box(3);
  problem.lower = {0.2, 0.0, 0.5};
  problem.upper = {0.4, 1.0, 0.6};
  for (const auto& x : spread_starts(problem, 200, 3)) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_GE(x[i], problem.lower[i]);
      EXPECT_LE(x[i], problem.upper[i]);
    }
  }
}

TEST(Starts, FewerAreTheFirstOfMoreAndTheSeedShiftsThem) {
  const auto many = spread_starts(box(4), 9, 1);
  const auto few = spread_starts(box(4), 4, 1);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_NE(spread_starts(box(4), 4, 2), few);
  EXPECT_TRUE(spread_starts(box(4), 0, 1).empty());
}

/// Largest difference between the points below t and t, along one coordinate: the star discrepancy.
double discrepancy(std::vector<double> u) {
  std::sort(u.begin(), u.end());
  double worst = 0.0;
  const auto n = static_cast<double>(u.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    worst = std::max({worst, std::abs(static_cast<double>(i) / n - u[i]),
                      std::abs(static_cast<double>(i + 1) / n - u[i])});
  }
  return worst;
}

TEST(Starts, LieMoreEvenlyAlongEveryCoordinateThanRandomPoints) {
  constexpr std::size_t kCount = 100;
  const auto points = spread_starts(box(12), kCount, 5);
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double mean = 0.0;
  double random_mean = 0.0;
  for (std::size_t i = 0; i < 12; ++i) {
    std::vector<double> along;
    std::vector<double> random;
    for (const auto& x : points) {
      along.push_back(x[i]);
      random.push_back(unit(generator));
    }
    mean += discrepancy(along) / 12.0;
    random_mean += discrepancy(random) / 12.0;
  }
  EXPECT_LT(mean, 0.6 * random_mean);
}

}  // namespace starts_test
}  // namespace armtune::internal
