#pragma once
// The rotor inertia that a URDF's transmissions give, which urdfdom does not read.

#include <map>
#include <string>

namespace armtune::internal {

/// Returns the rotor inertia that each joint feels [kg m^2, kg], by joint name: the rotor's own, times the
/// square of its gear ratio. An actuator gives both in the form that Drake reads,
/// `<drake:rotor_inertia value=".."/>` and `<drake:gear_ratio value=".."/>`; without a gear ratio its
/// `<mechanicalReduction>` counts, or 1. Several actuators of one joint add up. Joints whose actuators give
/// no rotor inertia are not in the map. Transmissions of several joints are left out, as a sum has no meaning
/// there. `path` begins messages. Throws InputError naming the joint and the value if one is not a number, is
/// negative, or is a gear ratio of zero.
std::map<std::string, double> rotor_inertias(const std::string& urdf, const std::string& path);

}  // namespace armtune::internal
