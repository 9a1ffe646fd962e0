#include "tuner/robustness/edge_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <string>

namespace armtune::internal {
namespace edge_search_test {

TEST(EdgeSearch, EndsBesideTheKnownEdgeOfANumber) {
  for (const double edge : {1.001, 1.3, 2.0, 31.4, 99.0}) {
    const auto holds = [edge](double value) { return value <= edge; };
    const Edge found = find_edge({.nominal = 1.0, .stride = 1.25, .last = 100.0}, holds);
    ASSERT_TRUE(found.fails) << edge;
    EXPECT_LE(found.holds, edge);
    EXPECT_GT(*found.fails, edge);
    EXPECT_LE(*found.fails / found.holds, 1.0 / (1.0 - 0.02)) << "neighbours are 2 % apart";
  }
}

TEST(EdgeSearch, GoesDownwardsWithAStrideBelowOne) {
  const Edge found =
      find_edge({.nominal = 500.0, .stride = 0.8, .last = 10.0}, [](double value) { return value >= 123.4; });
  ASSERT_TRUE(found.fails);
  EXPECT_GE(found.holds, 123.4);
  EXPECT_LT(*found.fails, 123.4);
  EXPECT_GE(*found.fails / found.holds, 0.98);
}

TEST(EdgeSearch, FindsAdjacentWholeNumbers) {
  for (int edge = 0; edge < 70; ++edge) {
    int tried = 0;
    const Edge found =
        find_edge({.nominal = 0.0, .first = 1.0, .last = 1000.0, .whole = true}, [&](double value) {
          ++tried;
          EXPECT_EQ(value, static_cast<int>(value));
          return value <= edge;
        });
    EXPECT_EQ(found.holds, edge);
    EXPECT_EQ(found.fails, edge + 1.0);
    EXPECT_LE(tried, 14) << "doubling to 128, then halving 64";
  }
}

TEST(EdgeSearch, StaysBelowTheFirstFailureEvenIfAnIslandLiesBeyond) {
  const Edge found = find_edge({.nominal = 1.0, .stride = 1.25, .last = 100.0},
                               [](double value) { return value < 3.0 || (value > 5.0 && value < 50.0); });
  EXPECT_LT(found.holds, 3.0);
  EXPECT_LT(*found.fails, 3.1);
}

TEST(EdgeSearch, SaysSoWhereNothingFails) {
  const auto always = [](double) { return true; };
  const Edge up = find_edge({.nominal = 1.0, .stride = 1.25, .last = 100.0}, always);
  EXPECT_EQ(up.holds, 100.0);
  EXPECT_FALSE(up.fails);
  const Edge down = find_edge({.nominal = 500.0, .stride = 0.8, .last = 10.0}, always);
  EXPECT_EQ(down.holds, 10.0);
  EXPECT_FALSE(down.fails);
  const Edge beyond = find_edge({.nominal = 200.0, .stride = 1.25, .last = 100.0}, always);
  EXPECT_EQ(beyond.holds, 200.0) << "nothing beyond the last is tried";
  EXPECT_FALSE(beyond.fails);
}

TEST(EdgeSearch, LooksBetweenZeroAndTheFirstValue) {
  const EdgeSearch search{.nominal = 0.0, .first = 0.01, .stride = 1.5, .last = 10.0};
  const Edge small = find_edge(search, [](double value) { return value <= 0.000345; });
  EXPECT_LE(small.holds, 0.000345);
  EXPECT_GT(small.holds, 0.000345 * 0.97);
  const Edge none = find_edge(search, [](double value) { return value == 0.0; });
  EXPECT_EQ(none.holds, 0.0);
  EXPECT_LE(none.fails, 1e-5);
}

TEST(EdgeSearch, TriesWhatIsPrinted) {
  find_edge({.nominal = 1.0, .stride = 1.25, .last = 100.0}, [](double value) {
    EXPECT_NEAR(value * 1e3, std::round(value * 1e3), 1e-9) << "four significant digits below ten";
    return value < 7.0;
  });
}

}  // namespace edge_search_test
}  // namespace armtune::internal
