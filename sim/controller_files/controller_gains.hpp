#pragma once
// Reads the gains of a controller from its ROS parameter file, for all controllers that armtune supports.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/placed_gain.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns the names of armtune's controllers that follow joint motions and have gains of their own for this.
std::vector<std::string> joint_motion_controllers();

/// Returns the names of the same controllers, and also that of cartesian_impedance, which follows paths of
/// the tool with gains of its own.
std::vector<std::string> motion_controllers();

/// Returns gains of one of motion_controllers() for n joints, with its defaults. Gains of the states that
/// track joints or avoid obstacles are 0, because a joint motion needs only the controller's own gains.
Gains joint_motion_gains(const std::string& kind, Eigen::Index n);

/// Returns the gains for an arm with these joints, in their order (joint_trajectory_file.hpp,
/// joint_impedance_file.hpp, gain_map.hpp). Throws InputError "FILE:LINE: what".
Gains controller_gains(const RosController& controller, const std::string& file,
                       const std::vector<std::string>& joints);

/// Returns every number of the file that is a gain, with its value in `gains`. `gains` must be for the kind
/// of controller in the file. The order depends on the file alone.
std::vector<PlacedGain> placed_gains(const RosController& controller, const std::string& file,
                                     const Gains& gains, const std::vector<std::string>& joints);

}  // namespace armtune::internal
