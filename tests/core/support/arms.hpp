#pragma once
// Arms that every law is tested on.

#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal::test {

/// The bundled UR10 with a tool 0.14 m along z of `tool0` and rotor inertia 0.1 kg m^2 on every joint.
RobotModel ur10();

/// Gives every joint the rotor inertia that its limits suggest, so that none is doubtful.
void fit_rotors(RobotModel& arm);

/// Seven revolute joints, measured roughly like a KUKA LBR iiwa 14, with full inertia tensors.
RobotModel seven_joint_arm();

/// A physically valid arm of n joints: random frames, axes, inertias, rotor inertia, friction, limits and
/// tool. With prismatic joints, every third one (the second, the fifth, ...) slides.
/// The same seed gives the same arm.
RobotModel random_arm(int n, unsigned seed, bool with_prismatic);

/// UR10, seven joints, and random arms: 6 and 12 joints with prismatic ones, 7 and 3 without.
std::vector<RobotModel> all_arms();

}  // namespace armtune::internal::test
