#pragma once
// Reads convex bodies (box, cylinder, capsule, sphere) from YAML files. They are the parts of a robot cell in
// scenario files, and the shapes of links and tools in robot files.

#include "sim/cell/solid.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// Reads one of these [m]:
///
///   box: [x, y, z]                   edges
///   cylinder: {radius, length}       along z
///   capsule: {radius, length}        along z, the length without its caps
///   sphere: {radius}
///
/// Throws InputError with file, line and key.
Solid read_solid(yaml::MapReader& map);

/// Reads one of these bodies with its place: `center` [m], zero by default, and `rpy_deg` (see read_turn). A
/// cylinder or a capsule between two points may be given as {radius, from: [x, y, z], to: [x, y, z]} instead.
PlacedSolid read_placed_solid(yaml::MapReader& map);

/// Reads rpy_deg: [roll, pitch, yaw], rotations about the fixed x, y and z axes in this order [deg]. If
/// the key is missing, returns the identity.
Mat3 read_turn(yaml::MapReader& map);

}  // namespace armtune::internal
