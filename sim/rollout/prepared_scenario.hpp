#pragma once
// A scenario together with everything that is computed from it once and used by all of its rollouts.

#include "core/robot/theta.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct PreparedScenario {
  explicit PreparedScenario(const Scenario& s)
      : scenario(s), plant(plant_model(s)), theta_start(start_theta(s)), theta_true(theta_of(plant.chain)) {}

  Scenario scenario;
  RobotModel plant;             ///< the simulated arm, as it differs from the controller's model
  ParameterVector theta_start;  ///< (13 n), from which the controller starts
  ParameterVector theta_true;   ///< (13 n), of the plant
};

}  // namespace armtune::internal
