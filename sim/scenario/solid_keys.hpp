#pragma once
// Convex bodies in files: of a cell, and of a tool.

#include "sim/cell/solid.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// One of these [m]:
///
///   box: [x, y, z]                   edges
///   cylinder: {radius, length}       along z
///   capsule: {radius, length}        along z, the length without its caps
///   sphere: {radius}
///
/// Throws InputError with file, line and key.
Solid read_solid(yaml::MapReader& map);

/// The same with its place: `center` [m], zero unless given, and `rpy_deg`. A cylinder or a capsule may be
/// {radius, from: [x, y, z], to: [x, y, z]} instead, from the one point to the other.
PlacedSolid read_placed_solid(yaml::MapReader& map);

/// rpy_deg: [roll, pitch, yaw], turned about fixed axes in that order; none: not turned.
Mat3 read_turn(yaml::MapReader& map);

}  // namespace armtune::internal
