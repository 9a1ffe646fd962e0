#pragma once
// One closed-loop simulation of a scenario: a pure function of scenario, gains, stepper and engine.

#include <functional>
#include <memory>
#include <string>

#include "core/control/gains.hpp"
#include "sim/metrics/metric.hpp"
#include "sim/plant/plant.hpp"
#include "sim/rollout/end_cost.hpp"
#include "sim/rollout/end_limit.hpp"
#include "sim/rollout/observation.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune {

enum class RolloutStatus {
  kCompleted,
  kDiverged,     ///< the state left every sensible range, or the engine gave up
  kHopeless,     ///< it passed one of its end limits, beyond repair
  kNoSamples,    ///< it ran to the end without a planned motion, but no period counted as tracking
  kInterrupted,  ///< the caller asked it to stop
  kOutdone       ///< it cost more than was of any use
};

constexpr const char* name(RolloutStatus status) {
  switch (status) {
    case RolloutStatus::kCompleted:
      return "completed";
    case RolloutStatus::kDiverged:
      return "diverged";
    case RolloutStatus::kHopeless:
      return "hopeless";
    case RolloutStatus::kOutdone:
      return "outdone";
    case RolloutStatus::kNoSamples:
      return "no_samples";
    case RolloutStatus::kInterrupted:
      return "interrupted";
  }
  return "";
}

struct RolloutResult {
  RolloutStatus status = RolloutStatus::kCompleted;
  double end_time = 0.0;  ///< [s] simulated
  std::string reason;     ///< when, where and why; empty if completed
  Metrics metrics;        ///< up to the end time
};

/// Called once per control period, after the controller and before the plant moves. Return false to stop.
using Observer = std::function<bool(const Observation&)>;

/// A scenario made ready to be run many times: model, plant, theta. One per thread.
class Rollout {
 public:
  Rollout(const Scenario& scenario, Stepper stepper, Engine engine = Engine::kSimbody);

  /// Runs the scenario from its start with these gains (valid for its robot). Nothing carries over from an
  /// earlier run. Diverging is a status, not an exception.
  /// limits: metrics, each one that only worsens, that end the rollout when they pass a value; cost: the same
  /// for a sum of such; none: it runs whole. Up to its end a rollout with limits is the one without.
  RolloutResult run(const Gains& gains, const Observer& observer = {}, const EndLimits& limits = {},
                    const EndCost& cost = {});

  const Scenario& scenario() const { return scenario_; }

 private:
  Scenario scenario_;
  RobotModel plant_model_;
  ParameterVector theta_start_;
  ParameterVector theta_true_;
  std::unique_ptr<Plant> plant_;
};

}  // namespace armtune
