#pragma once
// Simulates a scenario in closed loop with the controller. One such simulation is called a rollout. Its
// result is a pure function of the scenario, the gains, the stepper (the integration method) and the engine
// (the implementation of the arm's dynamics).

#include <memory>

#include "core/control/gains.hpp"
#include "sim/plant/plant.hpp"
#include "sim/rollout/end_limit.hpp"
#include "sim/rollout/prepared_scenario.hpp"
#include "sim/rollout/rollout_result.hpp"

namespace armtune::internal {

/// Simulates one scenario. The model of the arm is computed once, for any number of runs with different
/// gains. Each thread needs its own object.
class Rollout {
 public:
  Rollout(const Scenario& scenario, Stepper stepper, Engine engine = Engine::kSimbody);
  Rollout(std::shared_ptr<const PreparedScenario> prepared, Stepper stepper, Engine engine);

  /// Simulates the scenario from its start with these gains (valid for its robot). Nothing carries over from
  /// an earlier run. Divergence is a status, not an exception. limits: metrics that can only become worse
  /// during a rollout, such as a maximum, and the values at which they end the rollout. Without limits, the
  /// rollout runs to the end. Until the rollout ends, limits have no effect on it. series: metrics whose
  /// series the result shall have (rollout_series.hpp).
  RolloutResult run(const Gains& gains, const Observer& observer = {}, const EndLimits& limits = {},
                    const std::vector<Metric>& series = {});

  const Scenario& scenario() const { return prepared_->scenario; }

 private:
  std::shared_ptr<const PreparedScenario> prepared_;
  std::unique_ptr<Plant> plant_;
};

}  // namespace armtune::internal
