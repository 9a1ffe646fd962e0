#pragma once
// Simulates a scenario in closed loop with the controller. One such simulation is called a rollout. Its
// result is a pure function of scenario, gains, stepper and engine.

#include <memory>

#include "core/control/gains.hpp"
#include "sim/plant/plant.hpp"
#include "sim/rollout/end_limit.hpp"
#include "sim/rollout/prepared_scenario.hpp"
#include "sim/rollout/rollout_result.hpp"

namespace armtune::internal {

/// A simulator of one scenario. It computes the model of the arm once and can then run many times with
/// different gains. Each thread needs its own object.
class Rollout {
 public:
  Rollout(const Scenario& scenario, Stepper stepper, Engine engine = Engine::kSimbody);
  Rollout(std::shared_ptr<const PreparedScenario> prepared, Stepper stepper, Engine engine);

  /// Simulates the scenario from its start with these gains (valid for its robot). Nothing carries over from
  /// an earlier run. Divergence is a status, not an exception.
  /// limits: metrics that can only become worse during a rollout, such as a maximum, and the values at which
  /// they end the rollout. Without limits it runs to the end. Limits change nothing in a rollout before it
  /// ends.
  RolloutResult run(const Gains& gains, const Observer& observer = {}, const EndLimits& limits = {});

  const Scenario& scenario() const { return prepared_->scenario; }

 private:
  std::shared_ptr<const PreparedScenario> prepared_;
  std::unique_ptr<Plant> plant_;
};

}  // namespace armtune::internal
