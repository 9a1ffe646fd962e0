#pragma once
// Computes once the data that all rollouts (simulations) of a scenario share: the model of the simulated arm,
// and the dynamic parameters (theta) of controller and arm.

#include "core/robot/theta.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct PreparedScenario {
  explicit PreparedScenario(const Scenario& s)
      : scenario(s), plant(plant_model(s)), theta_start(start_theta(s)), theta_true(theta_of(plant.chain)) {}

  Scenario scenario;
  RobotModel plant;             ///< model of the simulated arm, which differs from the controller's model
  ParameterVector theta_start;  ///< parameters (13 n) with which the controller starts
  ParameterVector theta_true;   ///< parameters (13 n) of the simulated arm
};

}  // namespace armtune::internal
