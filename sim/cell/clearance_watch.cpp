#include "sim/cell/clearance_watch.hpp"

#include <algorithm>
#include <iterator>

namespace armtune::internal {

ClearanceWatch::ClearanceWatch(std::shared_ptr<const ClearanceModel> model,
                               const std::vector<double>& required)
    : distances_(std::move(model)),
      far_(distances_.size(), distances_.model().cell().parts.size()),
      spare_(distances_.size()),
      by_pair_(distances_.size()) {
  for (std::size_t k = 0; k < by_pair_.size(); ++k)
    by_pair_[k].distance = required.empty() ? -std::numeric_limits<double>::infinity() : required.at(k);
}

double ClearanceWatch::limit(std::size_t k) const {
  const auto kind = static_cast<std::size_t>(distances_.model().pairs()[k].of);
  return std::max(least_[kind].distance, by_pair_[k].distance);
}

void ClearanceWatch::look_at(std::size_t k, double time) {
  if (distances_.at_least(k, limit(k))) return;
  const ContactPair& pair = distances_.model().pairs()[k];
  LeastClearance& least = least_[static_cast<std::size_t>(pair.of)];
  LeastClearance& of_pair = by_pair_[k];
  const double distance = distances_.compute(k).distance;
  // NaN replaces any distance, because a contact cannot be excluded.
  if (!(distance >= least.distance)) least = {distance, time, &pair};
  if (!(distance >= of_pair.distance)) of_pair = {distance, time, &pair};
}

void ClearanceWatch::see(double time, const JointVector& q) {
  distances_.move_to(time, q);
  if (far_.stay_far(distances_)) {
    for (const std::size_t k : far_.near()) look_at(k, time);
    return;
  }
  for (std::size_t k = 0; k < distances_.size(); ++k) look_at(k, time);
  for (std::size_t k = 0; k < distances_.size(); ++k) spare_[k] = distances_.bound(k) - limit(k);
  far_.choose(distances_, spare_);
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
    if (!distances_.at_least(k, least_[static_cast<std::size_t>(pairs[k].of)].distance)) look_at(k);
  }
}

}  // namespace armtune::internal
