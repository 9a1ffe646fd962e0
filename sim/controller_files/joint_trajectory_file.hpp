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
///     two directions, a limit of the output (u_clamp), anti-windup that depends on such a limit, anti-windup
///     of some joints only, an error deadband, angle wraparound, or open-loop control by velocities,
///   - a joint has an integral gain and no clamp, which ROS distributions treat differently.
Gains joint_trajectory_gains(const RosController& controller, const std::string& file,
                             const std::vector<std::string>& joints);

/// Returns the places in the file of p, i, d, the clamps and the feed-forward of each joint, with their
/// values in `gains`.
std::vector<PlacedGain> placed_trajectory_gains(const RosController& controller, const std::string& file,
                                                const Gains& gains, const std::vector<std::string>& joints);

}  // namespace armtune::internal
