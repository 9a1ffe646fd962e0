#pragma once
// How candidates are simulated.

#include <vector>

#include "sim/plant/engine.hpp"
#include "sim/rollout/end_limit.hpp"

namespace armtune::internal {

struct Conditions {
  Engine engine = Engine::kSimbody;
  /// Per scenario, where its rollouts end before their time, those of every arm alike; empty: nowhere.
  std::vector<EndLimits> limits = {};
};

}  // namespace armtune::internal
