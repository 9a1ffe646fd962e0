#pragma once
// Reads the gains of a joint impedance controller from its ROS parameter file. The gains are in the lists
// k_gains and d_gains, as in the example controllers for Franka's arms.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/controller_files/placed_gain.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// Returns true if the controller's type is one of those listed below.
bool is_known_joint_impedance(const RosController& controller);

/// Returns the gains for an arm with these joints, in their order. The controller's type determines the
/// rest of the control law (franka_ros c11f000, franka_ros2 40cf08b):
///   - JointImpedanceExampleController in ROS 1: damps the velocity error, adds coriolis_factor times the
///     Coriolis torques, and limits the rate of the torques to 1000 N m/s;
///   - JointImpedanceExampleController in ROS 2: damps the velocity itself;
///   - JointImpedanceWithIKExampleController in ROS 2: damps the velocity itself and adds the Coriolis
///     torques.
/// Throws InputError "FILE:LINE: what" if the type is another one, the length of a list is not the number of
/// joints, the joint names are not those of the arm, or a value is not a number.
Gains joint_impedance_gains(const RosController& controller, const std::string& file,
                            const std::vector<std::string>& joints);

/// Returns the numbers of k_gains, d_gains and coriolis_factor in the file, with their values in `gains`.
std::vector<PlacedGain> placed_impedance_gains(const RosController& controller, const Gains& gains,
                                               const std::vector<std::string>& joints);

}  // namespace armtune::internal
