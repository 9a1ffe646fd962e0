#pragma once
// Reads the gains of a ROS joint_trajectory_controller from its parameter file, so that armtune can simulate
// and tune that controller.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/placed_gain.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns the distribution of ROS whose rules the controller follows: the one that is given, else Jazzy for
/// ROS 2 and Noetic for ROS 1.
RosDistro distro_of(const RosController& controller);

/// Returns true if the controller does not interpolate between the points of a trajectory
/// (`interpolation_method: none`, a parameter of ROS 2 alone). From the time of each point on, it tracks the
/// next one. Source: Trajectory::sample in ros2_controllers, at the commits of ros_distro.hpp.
bool jumps_between_points(const RosController& controller);

/// Returns the gains for an arm with these joints, in their order. Parameters that are neither gains nor in
/// the following list are ignored. Throws InputError "FILE:LINE: what" if:
///   - the file lacks a joint of the arm or has a joint that the arm lacks, or a value is not a number,
///   - the controller's commands are neither efforts alone nor velocities alone,
///   - a parameter requires something that armtune does not simulate: an upper clamp of the integral without
///     a lower one, anti-windup of some joints only, angle wraparound under Jazzy, or open-loop control by
///     velocities,
///   - a joint has an integral gain but no clamp, and the distribution takes a missing clamp for 0,
///   - a joint in a ROS 2 file has an integral gain but no clamp, and the distribution is not given: Humble
///     takes a missing clamp for 0, and Jazzy for no clamp.
Gains joint_trajectory_gains(const RosController& controller, const std::string& file,
                             const std::vector<std::string>& joints);

/// Returns, for each joint, where in the file its p, i, d, clamps and feed-forward stand, each with its value
/// from `gains`.
std::vector<PlacedGain> placed_trajectory_gains(const RosController& controller, const std::string& file,
                                                const Gains& gains, const std::vector<std::string>& joints);

}  // namespace armtune::internal
