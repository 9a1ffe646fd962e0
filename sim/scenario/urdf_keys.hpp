#pragma once
// Reads those keys of a robot YAML that select the arm within a URDF and add data that the URDF lacks:
//   base_link, tip_link: NAME
//   tool: {xyz: [m], rpy: [rad],                               the tool frame in the tip link
//          mass:, center:, moments:,                           inertia, in the form of the key inertia
//          shapes: [{box: [x, y, z], center: [m], rpy_deg:}]}  and its shapes (solid_keys.hpp)
//   hold: {JOINT: rad or m}                                    joints that do not move
//   limits: {JOINT: {lower:, upper:, velocity:, effort:, acceleration:}}
//                                                              each may be left out; joints in `hold` may
//                                                              have lower and upper only
//   inertia: {LINK: {mass:, center: [x, y, z], moments: [ixx, ixy, ixz, iyy, iyz, izz]}}
//   shapes: {LINK: [{capsule: {radius:, from:, to:}}, ...]}    in place of the link's collision geometry
// The inertia of a link is given in the link's frame, and that of a tool in the tool frame. The moments are
// about the centre of mass, along the axes of that frame. Only links that move may have inertia here.

#include "core/robot/urdf_options.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// Reads these keys. Throws InputError with file and line. It does not check whether the names exist in the
/// URDF; the reader of the URDF does.
UrdfOptions read_urdf_options(yaml::MapReader& map);

}  // namespace armtune::internal
