#include "tuner/trade_off/level_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace armtune::internal {
namespace level_grid_test {

TEST(LevelGrid, IsWalkedOnceInSingleSteps) {
  for (const std::size_t axes : {1U, 2U, 3U}) {
    for (const std::size_t levels : {2U, 3U, 5U}) {
      const auto grid = serpentine(axes, levels);
      const std::set<std::vector<std::size_t>> all(grid.begin(), grid.end());
      std::size_t count = 1;
      for (std::size_t a = 0; a < axes; ++a) count *= levels;
      EXPECT_EQ(grid.size(), count);
      EXPECT_EQ(all.size(), count) << "each once";
      for (std::size_t i = 1; i < grid.size(); ++i) {
        std::size_t steps = 0;
        for (std::size_t a = 0; a < axes; ++a) {
          EXPECT_LT(grid[i][a], levels);
          steps += std::max(grid[i][a], grid[i - 1][a]) - std::min(grid[i][a], grid[i - 1][a]);
        }
        EXPECT_EQ(steps, 1U) << "level " << i << " of " << axes << " axes";
      }
    }
  }
}

TEST(LevelGrid, GroupsHoldEveryPlaceOnceAndNoNeighbours) {
  for (std::size_t count = 1; count < 40; ++count) {
    std::vector<std::size_t> places;
    for (const auto& group : searched_together(count)) {
      EXPECT_LE(group.size(), 4U);
      EXPECT_FALSE(group.empty());
      for (std::size_t i = 1; i < group.size(); ++i) EXPECT_GE(group[i] - group[i - 1], 4U);
      places.insert(places.end(), group.begin(), group.end());
    }
    std::sort(places.begin(), places.end());
    std::vector<std::size_t> expected(count);
    std::iota(expected.begin(), expected.end(), std::size_t{0});
    EXPECT_EQ(places, expected);
  }
}

}  // namespace level_grid_test
}  // namespace armtune::internal
