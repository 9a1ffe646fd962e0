#include "tuner/trade_off/level_grid.hpp"

namespace armtune::internal {

std::vector<std::vector<std::size_t>> serpentine(std::size_t axes, std::size_t levels) {
  std::vector<std::vector<std::size_t>> grid(1);
  for (std::size_t a = 0; a < axes; ++a) {
    std::vector<std::vector<std::size_t>> finer;
    finer.reserve(grid.size() * levels);
    for (std::size_t i = 0; i < grid.size(); ++i) {
      for (std::size_t d = 0; d < levels; ++d) {
        finer.push_back(grid[i]);
        finer.back().insert(finer.back().begin(), i % 2 == 0 ? d : levels - 1 - d);
      }
    }
    grid = std::move(finer);
  }
  return grid;
}

std::vector<std::vector<std::size_t>> searched_together(std::size_t count) {
  constexpr std::size_t kTogether = 4;
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t first : {0U, 2U, 1U, 3U}) {
    for (std::size_t place = first; place < count; place += kTogether) {
      if (groups.empty() || groups.back().size() == kTogether || place == first) groups.emplace_back();
      groups.back().push_back(place);
    }
  }
  return groups;
}

}  // namespace armtune::internal
