#include "tuner/trade_off/front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace armtune::internal {
namespace front_test {

std::vector<Costs> random_points(std::size_t count, std::size_t criteria, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform;
  std::vector<Costs> points(count, Costs(criteria));
  for (Costs& point : points) {
    for (double& c : point) c = uniform(generator);
  }
  return points;
}

TEST(Dominance, IsNowhereWorseAndSomewhereBetter) {
  EXPECT_TRUE(dominates({1, 2}, {1, 3}));
  EXPECT_TRUE(dominates({0, 2}, {1, 3}));
  EXPECT_FALSE(dominates({1, 3}, {1, 2}));
  EXPECT_FALSE(dominates({1, 2}, {1, 2}));
  EXPECT_FALSE(dominates({0, 4}, {1, 3}));
  EXPECT_FALSE(dominates({NAN, 0}, {1, 3}));
}

TEST(NonDominated, IsWhatNoOtherPointDominates) {
  for (const std::size_t criteria : {2U, 3U}) {
    auto points = random_points(200, criteria, 3);
    points.push_back(points[5]);
    points.push_back({NAN, 0.0, 0.0});
    points.back().resize(criteria);
    const auto front = non_dominated(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool beaten = std::any_of(points.begin(), points.end(),
                                      [&](const Costs& other) { return dominates(other, points[i]); });
      const bool listed = std::find(front.begin(), front.end(), i) != front.end();
      if (i == 200 || i == 201) {
        EXPECT_FALSE(listed) << "a copy or NaN";
      } else {
        EXPECT_EQ(listed, !beaten) << i;
      }
    }
    for (std::size_t i = 1; i < front.size(); ++i) EXPECT_LE(points[front[i - 1]][0], points[front[i]][0]);
  }
}

TEST(Hypervolume, OfOnePointIsItsBox) {
  EXPECT_DOUBLE_EQ(hypervolume({{0.25, 0.5}}, {1.0, 1.0}), 0.75 * 0.5);
  EXPECT_DOUBLE_EQ(hypervolume({{0.5, 1.0, 3.0}}, {2.0, 2.0, 4.0}), 0.75 * 0.5 * 0.25);
  EXPECT_DOUBLE_EQ(hypervolume({{-3.0, 0.5}}, {-2.0, 1.0}), 0.5 * 0.5) << "more is better: -2 became -3";
  EXPECT_EQ(hypervolume({{0.5, 1.0}, {1.5, 0.1}}, {1.0, 1.0}), 0.0) << "nothing better in everything";
  EXPECT_EQ(hypervolume({}, {1.0, 1.0}), 0.0);
}

TEST(Hypervolume, IsTheShareThatIsDominated) {
  for (const std::size_t criteria : {2U, 3U}) {
    const auto points = random_points(12, criteria, 7);
    const auto probes = random_points(40000, criteria, 8);
    std::size_t under = 0;
    for (const Costs& probe : probes) {
      const bool dominated =
          std::any_of(points.begin(), points.end(), [&](const Costs& p) { return dominates(p, probe); });
      if (dominated) ++under;
    }
    const double share = static_cast<double>(under) / static_cast<double>(probes.size());
    const double exact = hypervolume(points, Costs(criteria, 1.0));
    EXPECT_NEAR(exact, share, 4.0 * std::sqrt(share * (1.0 - share) / static_cast<double>(probes.size())));
  }
}

TEST(Hypervolume, CountsOnlyTheFront) {
  const auto points = random_points(50, 3, 9);
  std::vector<Costs> front;
  for (const std::size_t i : non_dominated(points)) front.push_back(points[i]);
  ASSERT_LT(front.size(), points.size());
  EXPECT_NEAR(hypervolume(front, {1, 1, 1}), hypervolume(points, {1, 1, 1}), 1e-12);
}

}  // namespace front_test
}  // namespace armtune::internal
