#pragma once
// One closed-loop simulation of a scenario: a pure function of scenario, gains, stepper and engine.

#include <memory>

#include "core/control/gains.hpp"
#include "sim/plant/plant.hpp"
#include "sim/rollout/end_limit.hpp"
#include "sim/rollout/prepared_scenario.hpp"
#include "sim/rollout/rollout_result.hpp"

namespace armtune::internal {

/// A scenario made ready to be run many times: model, plant, theta. One per thread.
class Rollout {
 public:
  Rollout(const Scenario& scenario, Stepper stepper, Engine engine = Engine::kSimbody);
  Rollout(std::shared_ptr<const PreparedScenario> prepared, Stepper stepper, Engine engine);

  /// Runs the scenario from its start with these gains (valid for its robot). Nothing carries over from an
  /// earlier run. Diverging is a status, not an exception.
  /// limits: metrics, each one that only worsens, that end the rollout when they pass a value; none: it runs
  /// whole. Up to its end a rollout with limits is the one without.
  RolloutResult run(const Gains& gains, const Observer& observer = {}, const EndLimits& limits = {});

  const Scenario& scenario() const { return prepared_->scenario; }

 private:
  std::shared_ptr<const PreparedScenario> prepared_;
  std::unique_ptr<Plant> plant_;
};

}  // namespace armtune::internal
