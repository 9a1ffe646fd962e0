#include "tuner/search/seen.hpp"

#include <algorithm>

namespace armtune::internal {
namespace {

bool inside(const std::vector<double>& x, const WarmPoint& box) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < box.lower[i] || x[i] > box.upper[i]) return false;
  }
  return true;
}

}  // namespace

void Seen::take(const Evaluation& e, const WarmPoint& box) {
  values_[e.x] = {e.objective, e.relative};
  if (!start) start = e;
  const bool known =
      std::any_of(best_.begin(), best_.end(), [&e](const Evaluation& b) { return b.x == e.x; });
  if (!known) {
    best_.insert(std::upper_bound(best_.begin(), best_.end(), e, better), e);
    if (best_.size() > kBest) best_.pop_back();
  }
  if (inside(e.x, box) && (!best_inside_ || better(e, *best_inside_))) best_inside_ = e;
}

}  // namespace armtune::internal
