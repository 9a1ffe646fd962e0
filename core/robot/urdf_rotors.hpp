#pragma once
// Rotor inertias from the transmissions of a URDF, which urdfdom does not read.

#include <map>
#include <string>

namespace armtune::internal {

/// Returns the rotor inertia that each joint feels [kg m^2, kg], by joint name: the rotor's own, times the
/// square of its gear ratio. An actuator gives both in the form that Drake reads,
/// `<drake:rotor_inertia value=".."/>` and `<drake:gear_ratio value=".."/>`. Without a gear ratio its
/// `<mechanicalReduction>` is used, or 1. Several actuators of one joint add up. Joints whose actuators give
/// no rotor inertia are not in the map. Transmissions with several joints are skipped, since a sum has no
/// meaning there. Messages begin with `path`. Throws InputError, naming the joint and the value, if a value
/// is not a number, a rotor inertia is negative or a gear ratio is zero; and if the text is not valid XML.
std::map<std::string, double> rotor_inertias(const std::string& urdf, const std::string& path);

}  // namespace armtune::internal
