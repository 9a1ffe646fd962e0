#include "tuner/trade_off/archive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace armtune::internal {
namespace archive_test {

ParetoPoint point(double a, double b, bool feasible = true) {
  ParetoPoint p;
  p.costs = {a, b};
  p.e.feasible = feasible;
  p.e.x = {a, b};
  return p;
}

TEST(Archive, HoldsWhatNothingSeenDominatesWhateverTheOrder) {
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> cost(0.0, 1.0);
  Archive archive;
  std::vector<Costs> seen;
  for (int i = 0; i < 300; ++i) {
    const ParetoPoint p = point(cost(draw), cost(draw), i % 5 != 0);
    if (p.e.feasible) seen.push_back(p.costs);
    archive.add(p);
  }
  archive.add(archive.points().front());  // an equal one adds nothing
  archive.add(point(NAN, 0.0));
  EXPECT_EQ(archive.points().size(), non_dominated(seen).size());
  for (const ParetoPoint& p : archive.points()) {
    EXPECT_TRUE(p.e.feasible);
    for (const Costs& other : seen) EXPECT_FALSE(dominates(other, p.costs));
  }
}

TEST(Archive, FindsTheBestUnderLevelsAndWhereToBegin) {
  Archive archive;
  const ParetoPoint start = point(1.0, 1.0);
  EXPECT_EQ(archive.best_under(0, {HUGE_VAL, HUGE_VAL}), nullptr);
  EXPECT_EQ(archive.beginning({HUGE_VAL, 0.5}, start), start.e.x);
  for (const auto& [a, b] : {std::pair{0.9, 0.1}, std::pair{0.5, 0.5}, std::pair{0.2, 0.8}})
    archive.add(point(a, b));
  EXPECT_EQ(archive.best_under(0, {HUGE_VAL, HUGE_VAL})->costs[0], 0.2);
  EXPECT_EQ(archive.best_under(0, {HUGE_VAL, 0.6})->costs[0], 0.5);
  EXPECT_EQ(archive.best_under(1, {0.4, HUGE_VAL})->costs[1], 0.8);
  EXPECT_EQ(archive.best_under(0, {HUGE_VAL, 0.05}), nullptr);
  EXPECT_EQ(archive.beginning({HUGE_VAL, 0.5}, start), (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(archive.beginning({HUGE_VAL, 0.49}, start), (std::vector<double>{0.5, 0.5}))
      << "0.01 above the level costs less than 0.4 of the first";
}

}  // namespace archive_test
}  // namespace armtune::internal
