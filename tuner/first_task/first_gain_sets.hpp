#pragma once
// Gains that are tried one after the other on an arm that has none: starting gains, and what differs from
// them by a few factors.

#include <vector>

#include "core/control/gains.hpp"

namespace armtune::internal {

/// Returns `start` under every set of factors that is tried, those first that are to be preferred: Kp and Kd,
/// the adaptation and both duration gains differ. `start` itself is the first.
std::vector<Gains> first_gain_sets(const Gains& start);

}  // namespace armtune::internal
