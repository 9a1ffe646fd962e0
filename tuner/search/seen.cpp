#include "tuner/search/seen.hpp"

#include <algorithm>
#include <cmath>

namespace armtune {
namespace {

bool inside(const std::vector<double>& x, const WarmPoint& box) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < box.lower[i] || x[i] > box.upper[i]) return false;
  }
  return true;
}

}  // namespace

void Seen::take(const Evaluation& e, const WarmPoint& box) {
  SolverValue& value = values_[e.x] = {e.objective, e.relative, e.beyond};
  if (std::isfinite(e.beyond)) value.objective = std::max(e.objective, std::nextafter(e.beyond, HUGE_VAL));

  if (!start) start = e;
  const bool known =
      std::any_of(best_.begin(), best_.end(), [&e](const Evaluation& b) { return b.x == e.x; });
  if (!known) {
    best_.insert(std::upper_bound(best_.begin(), best_.end(), e, better), e);
    if (best_.size() > kBest) best_.pop_back();
  }
  if (inside(e.x, box) && (!best_inside_ || better(e, *best_inside_))) best_inside_ = e;
}

double Seen::bar() const {
  if (best_.size() < kBest || !best_.back().feasible || !best_inside_ || !best_inside_->feasible) {
    return HUGE_VAL;
  }
  return std::max(best_.back().objective, best_inside_->objective);
}

}  // namespace armtune
