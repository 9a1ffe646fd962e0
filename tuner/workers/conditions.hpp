#pragma once
// How candidates are simulated.

#include <optional>
#include <vector>

#include "sim/plant/engine.hpp"
#include "sim/rollout/end_limit.hpp"
#include "tuner/workers/outdone.hpp"

namespace armtune {

struct Conditions {
  Engine engine = Engine::kSimbody;
  /// Per scenario, where its rollouts end before their time, those of every arm alike; empty: nowhere.
  std::vector<EndLimits> limits = {};
  /// How candidates are given up; not with a sample set.
  std::optional<Outdone> outdone = {};
  /// Per candidate, for `outdone`; HUGE_VAL: it is simulated whole. Empty: all are.
  std::vector<double> bars = {};
};

}  // namespace armtune
