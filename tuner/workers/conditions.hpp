#pragma once
// The conditions under which candidate gain sets are simulated: the simulation engine, and the limits at
// which a rollout ends early.

#include <vector>

#include "sim/plant/engine.hpp"
#include "sim/rollout/end_limit.hpp"

namespace armtune::internal {

struct Conditions {
  Engine engine = Engine::kSimbody;
  /// Limits at which rollouts end early, one entry per scenario, for all arms. Empty if there are no limits.
  std::vector<EndLimits> limits = {};
};

}  // namespace armtune::internal
