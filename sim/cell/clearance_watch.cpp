#include "sim/cell/clearance_watch.hpp"

#include <algorithm>
#include <iterator>

namespace armtune::internal {

ClearanceWatch::ClearanceWatch(std::shared_ptr<const ClearanceModel> model,
                               const std::vector<double>& required)
    : distances_(std::move(model)), by_pair_(distances_.size()) {
  for (std::size_t k = 0; k < by_pair_.size(); ++k)
    by_pair_[k].distance = required.empty() ? -std::numeric_limits<double>::infinity() : required.at(k);
}

void ClearanceWatch::see(double time, const JointVector& q) {
  distances_.move_to(time, q);
  const auto& pairs = distances_.model().pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    LeastClearance& least = least_[static_cast<std::size_t>(pairs[k].of)];
    LeastClearance& of_pair = by_pair_[k];
    if (distances_.at_least(k) >= std::max(least.distance, of_pair.distance)) continue;
    const double distance = distances_.compute(k).distance;
    // NaN replaces any distance, because a contact cannot be excluded.
    if (!(distance >= least.distance)) least = {distance, time, &pairs[k]};
    if (!(distance >= of_pair.distance)) of_pair = {distance, time, &pairs[k]};
  }
}

std::vector<LeastClearance> ClearanceWatch::too_near() const {
  std::vector<LeastClearance> found;
  std::copy_if(by_pair_.begin(), by_pair_.end(), std::back_inserter(found),
               [](const LeastClearance& of_pair) { return of_pair.pair != nullptr; });
  return found;
}

void ClearanceNow::see(double time, const JointVector& q) {
  if (time == time_) return;
  time_ = time;
  distances_.move_to(time, q);
  const auto& pairs = distances_.model().pairs();
  least_ = {};
  closest_ = {};
  double closest = std::numeric_limits<double>::infinity();
  const auto look_at = [&](std::size_t k) {
    const auto kind = static_cast<std::size_t>(pairs[k].of);
    const Closest& found = distances_.compute(k);
    if (!(found.distance >= least_[kind].distance)) {
      least_[kind] = {found.distance, time, &pairs[k]};
      last_[kind] = k;
    }
    if (!(found.distance >= closest)) {
      closest = found.distance;
      closest_ = found;
    }
  };
  // The closest pair of the last call is probably still the closest. Computed first, it excludes most others.
  const auto first = last_;
  for (const std::size_t k : first) {
    if (k < pairs.size()) look_at(k);
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (distances_.at_least(k) < least_[static_cast<std::size_t>(pairs[k].of)].distance) look_at(k);
  }
}

}  // namespace armtune::internal
