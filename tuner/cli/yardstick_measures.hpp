#pragma once
// The yardstick of a folder's rollouts: measured with progress, told, written.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/control/gains.hpp"
#include "tuner/planning/yardstick/yardstick.hpp"

namespace armtune::internal::cli {

/// Gains that a scenario was simulated with.
using GainsOf = std::function<Gains(const Scenario&)>;

struct RolloutMeasures {
  std::vector<Measure> measures;
  /// Recordings that were read, and the hash of what was read of each.
  std::vector<std::pair<std::string, std::string>> recordings;
};

/// Every event of rollout_<scenario>.csv in the folder beside its limit, each told on stdout as it is found.
/// The gaze threshold and the clearance are the gains'. Interrupted, it ends with what is finished. A
/// scenario with a stimulus is left out, and that is told: no plan knows it. Throws InputError if a rollout
/// cannot be read.
RolloutMeasures measure_rollouts(const std::string& folder, const std::vector<Scenario>& scenarios,
                                 const GainsOf& gains, YardstickOptions options);

}  // namespace armtune::internal::cli
