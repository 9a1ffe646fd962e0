#pragma once
// Compares recorded rollouts with the best motions that the planner finds within the arm's limits. There is
// one result for each event of a rollout: a target switch, a return to the path, or a lap.

#include <atomic>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/control/gains.hpp"
#include "tuner/planning/yardstick/yardstick.hpp"
#include "tuner/session/observer.hpp"

namespace armtune::internal {

/// An observer of the comparison. The progress counts events.
class YardstickObserver : public SessionObserver {
 public:
  /// Called with a note on a scenario, such as the reason why it is left out.
  virtual void noted(const std::string& /*scenario*/, const std::string& /*note*/) {}
  /// Called with each result as soon as it is found. scenario: index of its scenario.
  virtual void measured(const Measure& /*measure*/, std::size_t /*scenario*/) {}
};

/// Returns the gains that a scenario was simulated with.
using GainsOf = std::function<Gains(const Scenario&)>;

struct RolloutMeasures {
  std::vector<Measure> measures;
  /// Recordings that were read, each with the hash of the bytes read.
  std::vector<std::pair<std::string, std::string>> recordings;
};

/// Compares every event of rollout_<scenario>.csv in the folder with the best motion that the arm's limits
/// allow. The threshold of the gaze error and the clearance from obstacles come from the gains. If `stop`
/// becomes true, it returns the results found so far. Scenarios that the planner cannot model are left out,
/// with a note to the observer. These have a stimulus (a step or sines), a given orientation of the tool, or
/// the position as their only task. Throws InputError if a rollout cannot be read.
RolloutMeasures measure_rollouts(const std::string& folder, const std::vector<Scenario>& scenarios,
                                 const GainsOf& gains, YardstickOptions options,
                                 const std::atomic<bool>& stop, YardstickObserver& observer);

}  // namespace armtune::internal
