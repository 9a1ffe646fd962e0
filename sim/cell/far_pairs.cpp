#include "sim/cell/far_pairs.hpp"

#include <algorithm>
#include <limits>

namespace armtune::internal {
namespace {

/// Spare distance from which a pair is far [m]. With a smaller one, pairs are chosen anew more often. With a
/// larger one, more pairs are examined one by one.
constexpr double kFar = 0.05;

}  // namespace

FarPairs::FarPairs(std::size_t pairs, std::size_t parts) {
  near_.reserve(pairs);
  parts_.reserve(parts);
}

void FarPairs::choose(const PairDistances& distances, const std::vector<double>& spare) {
  const auto& pairs = distances.model().pairs();
  near_.clear();
  q_ = distances.position();
  parts_ = distances.parts();
  spare_ = std::numeric_limits<double>::infinity();
  lever_.setZero(q_.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!(spare[k] >= kFar)) {
      near_.push_back(k);
      continue;
    }
    spare_ = std::min(spare_, spare[k]);
    lever_ = lever_.cwiseMax(pairs[k].lever).eval();
  }
}

bool FarPairs::stay_far(const PairDistances& distances) const {
  if (q_.size() == 0 || !distances.levers_hold()) return false;
  double moved = 0.0;
  for (std::size_t p = 0; p < parts_.size(); ++p)
    moved = std::max(moved, (distances.parts()[p] - parts_[p]).norm());
  return lever_.dot((distances.position() - q_).cwiseAbs()) + moved <= spare_;
}

}  // namespace armtune::internal
