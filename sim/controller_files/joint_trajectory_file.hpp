#pragma once
// Reads the gains of a ROS joint_trajectory_controller from its parameter file, so that armtune can simulate
// and tune that controller.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/placed_gain.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns the gains for an arm with these joints, in their order. Parameters that are neither gains nor in
/// the following list are ignored. Throws InputError "FILE:LINE: what" if:
///   - the file lacks a joint of the arm or has a joint that the arm lacks, or a value is not a number,
///   - the controller's commands are neither efforts alone nor velocities alone,
///   - a parameter requires something that armtune does not simulate: an integral clamp that differs in the
///     two directions, anti-windup of some joints only, angle wraparound, or open-loop control by velocities,
///   - a joint has an integral gain and neither a clamp nor an antiwindup_strategy, which ROS distributions
///     treat differently.
Gains joint_trajectory_gains(const RosController& controller, const std::string& file,
                             const std::vector<std::string>& joints);

/// Returns, for each joint, where in the file its p, i, d, clamps and feed-forward stand, each with its value
/// from `gains`.
std::vector<PlacedGain> placed_trajectory_gains(const RosController& controller, const std::string& file,
                                                const Gains& gains, const std::vector<std::string>& joints);

}  // namespace armtune::internal
