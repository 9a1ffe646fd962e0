#pragma once
// The conditions under which candidates are simulated.

#include <vector>

#include "sim/plant/engine.hpp"
#include "sim/rollout/end_limit.hpp"

namespace armtune::internal {

struct Conditions {
  Engine engine = Engine::kSimbody;
  /// Limits at which rollouts end early, per scenario and for all of its arms; empty: none.
  std::vector<EndLimits> limits = {};
};

}  // namespace armtune::internal
