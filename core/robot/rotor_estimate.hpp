#pragma once
// What a joint feels of its motor's rotor, estimated where nobody gives it. A geared joint feels its rotor
// times the square of the gear ratio, which for the wrists of an arm is many times what their links weigh.

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Time in which a rotor alone reaches the joint's velocity limit at the joint's effort limit [s].
///
/// Motors are chosen so that their own rotor costs them a small part of the time that a move takes. In
/// published figures that time lies between 14 and 90 ms: 14 to 90 for the seven joints of the Franka
/// Research 3 (Franka's figures, as the Drake project's model of the arm quotes them), 28 to 56 for the five
/// of the KUKA youBot (its motors and gear ratios). A thirtieth of a second is within a factor of 3 of all of
/// them.
inline constexpr double kRotorTime = 1.0 / 30.0;

/// A result that rests on the estimate has to hold from the estimate divided by this factor to the estimate
/// times it.
inline constexpr double kRotorFactor = 3.0;

/// Sets the rotor inertia of every joint that has none to kRotorTime * effort limit / velocity limit
/// [kg m^2, kg], and adds its name to `estimated_rotors`.
void estimate_rotors(RobotModel& model);

/// Returns whether the rotor inertia of joint i (0 ..) is an estimate.
bool has_estimated_rotor(const RobotModel& model, int i);

}  // namespace armtune::internal
