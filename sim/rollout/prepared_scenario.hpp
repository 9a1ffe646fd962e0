#pragma once
// Computes once the data that all rollouts (simulations) of a scenario share: the model of the simulated arm,
// and the dynamic parameters (theta) of controller and arm.

#include "core/control/laws/joint_drives.hpp"
#include "core/robot/theta.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct PreparedScenario {
  explicit PreparedScenario(const Scenario& s)
      : scenario(s), plant(plant_model(s)), theta_start(start_theta(s)), theta_true(theta_of(plant.chain)) {}

  /// Returns the times of the robot's drives, which a controller uses if it commands velocities or positions.
  DriveTiming drive_timing() const {
    return {drive_frequency(*scenario.robot, scenario.plant.rate), scenario.plant.torque_delay_periods};
  }

  Scenario scenario;
  RobotModel plant;             ///< model of the simulated arm, which differs from the controller's model
  ParameterVector theta_start;  ///< parameters (13 n) with which the controller starts
  ParameterVector theta_true;   ///< parameters (13 n) of the simulated arm
};

}  // namespace armtune::internal
