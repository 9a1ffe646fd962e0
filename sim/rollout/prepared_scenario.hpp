#pragma once
// A scenario with what is computed from it once, however often it is run.

#include "core/robot/theta.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct PreparedScenario {
  explicit PreparedScenario(const Scenario& s)
      : scenario(s), plant(plant_model(s)), theta_start(start_theta(s)), theta_true(theta_of(plant.chain)) {}

  Scenario scenario;
  RobotModel plant;             ///< the arm as it really is
  ParameterVector theta_start;  ///< (13 n), what the controller begins with
  ParameterVector theta_true;   ///< of the plant
};

}  // namespace armtune::internal
