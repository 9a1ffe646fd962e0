#pragma once
// Reads the gains of a ROS joint_trajectory_controller from its parameter file, so that armtune can simulate
// and tune that controller.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns the gains for an arm with these joints, in their order. All other parameters are ignored. Throws
/// InputError "FILE:LINE: what" if:
///   - a joint is missing or not the arm's, or a value is not a number,
///   - commands are neither efforts nor velocities alone,
///   - a parameter requires something that is not simulated: clamps that differ in both directions, limits of
///     the output and anti-windup that depends on them, anti-windup of some joints only, an error deadband,
///     angle wraparound, or open-loop control by velocities,
///   - a joint has an integral gain and no clamp, which ROS distributions treat differently.
Gains joint_trajectory_gains(const RosController& controller, const std::string& file,
                             const std::vector<std::string>& joints);

}  // namespace armtune::internal
