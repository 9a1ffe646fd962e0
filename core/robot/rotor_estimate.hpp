#pragma once
// Estimates the rotor inertia of joint motors when the robot's files do not give it. At a geared joint, the
// rotor's inertia counts times the square of the gear ratio. In the wrists of an arm this is many times the
// inertia of the links.

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Time in which a rotor alone reaches the joint's velocity limit at the joint's effort limit [s].
///
/// Motors are chosen so that their own rotor takes a small part of the time of a move. In published figures
/// kRotorTime lies between 14 and 90 ms: 14 to 90 for the seven joints of the Franka Research 3 (Franka's
/// figures, as the Drake project's model of the arm quotes them), 28 to 56 for the five of the KUKA youBot
/// (its motors and gear ratios). A thirtieth of a second is within a factor of 3 of all of them.
inline constexpr double kRotorTime = 1.0 / 30.0;

/// The uncertainty of the estimate. A result that depends on the estimate must hold for every rotor inertia
/// from the estimate divided by this factor to the estimate times this factor.
inline constexpr double kRotorFactor = 3.0;

/// Sets the rotor inertia of every joint that has none to kRotorTime * effort limit / velocity limit
/// [kg m^2, kg], and adds its name to `estimated_rotors`.
void estimate_rotors(RobotModel& model);

/// True if the rotor inertia of joint i (0 ..) is an estimate.
bool has_estimated_rotor(const RobotModel& model, int i);

}  // namespace armtune::internal
