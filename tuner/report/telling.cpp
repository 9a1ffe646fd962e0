#include "tuner/report/telling.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "tuner/report/findings.hpp"

namespace armtune::internal::report {

std::vector<std::size_t> telling_order(const std::vector<std::string>& names,
                                       const std::vector<Table>& tables, std::size_t set) {
  std::map<std::string, int> rank;
  const auto limits = limits_of_arm();
  for (const Table& table : tables) {
    const bool failed = !failures({table}, set).empty();
    rank[table.scenario] = failed ? 0 : !violations({table}, limits, set).empty() ? 1 : 2;
  }
  const auto rank_of = [&](std::size_t i) {
    const auto found = rank.find(names[i]);
    return found == rank.end() ? 2 : found->second;
  };
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank_of(a) < rank_of(b); });
  return order;
}

}  // namespace armtune::internal::report
