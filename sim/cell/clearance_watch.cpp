#include "sim/cell/clearance_watch.hpp"

namespace armtune::internal {

void ClearanceWatch::see(double time, const JointVector& q) {
  distances_.move_to(time, q);
  const auto& pairs = distances_.model().pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    LeastClearance& least = least_[static_cast<std::size_t>(pairs[k].of)];
    if (distances_.at_least(k) >= least.distance) continue;
    const double distance = distances_.compute(k).distance;
    // NaN replaces any distance, because a contact cannot be excluded.
    if (!(distance >= least.distance)) least = {distance, time, &pairs[k]};
  }
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
