#pragma once
// Estimates the rotor inertia of joint motors when the robot's files do not give it. At a geared joint, the
// rotor's inertia is multiplied by the square of the gear ratio. In the wrists of an arm this is many times
// the inertia of the links.

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Time in which the joint's effort limit accelerates the rotor alone from rest to the joint's velocity limit
/// [s].
///
/// Motors are usually chosen so that this time is a small part of the time of a move. In the published data
/// of three families of arms it lies between 14 and 90 ms:
///   - 14 to 90 ms for the seven joints of the Franka Research 3 (data of Franka, quoted in Drake's model of
///     the arm),
///   - 28 to 56 ms for the five joints of the KUKA youBot (from its motors and gear ratios),
///   - 39 ms for the first three joints of the Manutec r3, an industrial robot for 15 kg (measured by DLR,
///     see Tuerk, Fortschrittberichte VDI 8 (211), 1990; quoted in RobotR3 of the Modelica Standard Library).
///     No torque limits are published for its wrist.
/// 1/30 s is within a factor of 3 of all these values.
inline constexpr double kRotorTime = 1.0 / 30.0;

/// The uncertainty of the estimate. A result that depends on the estimate must hold for every rotor inertia
/// from the estimate divided by this factor to the estimate times this factor.
inline constexpr double kRotorFactor = 3.0;

/// Estimates the rotor inertia of every joint that has none: kRotorTime * effort limit / velocity limit
/// [kg m^2, kg]. Adds the names of these joints to `estimated_rotors`.
void estimate_rotors(RobotModel& model);

/// True if the rotor inertia of joint i (0 ..) is an estimate.
bool has_estimated_rotor(const RobotModel& model, int i);

}  // namespace armtune::internal
