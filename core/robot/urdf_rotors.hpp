#pragma once
// Reads rotor inertias from the transmissions of a URDF. The URDF parser urdfdom does not read transmissions.

#include <map>
#include <string>

namespace armtune::internal {

/// Returns the rotor inertia that acts at each joint [kg m^2, kg], by joint name. It is the inertia of the
/// rotor itself, times the square of the gear ratio. An actuator gives these two values in the form that
/// Drake reads, `<drake:rotor_inertia value=".."/>` and `<drake:gear_ratio value=".."/>`. Without a gear
/// ratio its `<mechanicalReduction>` is used, or 1. The inertias of several actuators of one joint are added.
/// Joints whose actuators give no rotor inertia are not in the map. Transmissions with several joints are
/// skipped, since a sum has no meaning there. Throws InputError, naming the joint and the value, if a value
/// is not a number, a rotor inertia is negative or a gear ratio is zero. Also throws InputError if the text
/// is not valid XML. Messages begin with `path`.
std::map<std::string, double> rotor_inertias(const std::string& urdf, const std::string& path);

}  // namespace armtune::internal
