#pragma once
// The keys of a robot YAML that say what of a URDF is the arm and what the URDF does not say:
//   base_link, tip_link: NAME
//   tool: {xyz: [m], rpy: [rad],                               the tool frame in the tip link
//          mass:, center:, moments:,                           what is mounted there, as under inertia
//          shapes: [{box: [x, y, z], center: [m], rpy_deg:}]}  and its shapes (solid_keys.hpp)
//   hold: {JOINT: rad or m}                                    joints that do not move
//   limits: {JOINT: {lower:, upper:, velocity:, effort:}}      each may be left out; of joints that move, and
//                                                              lower and upper of held ones
//   inertia: {LINK: {mass:, center: [x, y, z], moments: [ixx, ixy, ixz, iyy, iyz, izz]}}
//   shapes: {LINK: [{capsule: {radius:, from:, to:}}, ...]}    in place of the link's collision geometry
// Inertia is in the link's frame, a tool's in the tool frame: moments about the centre of mass along that
// frame's axes; of links that move.

#include "core/robot/urdf_options.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// Throws InputError with file and line. Whether the names are the URDF's is for its reader.
UrdfOptions read_urdf_options(yaml::MapReader& map);

/// A robot YAML, or what is to be added to one, with an empty value for all that is missing, which its reader
/// asks for by its line. urdf: named at the top if it is not empty.
std::string missing_yaml(const std::string& urdf, const MissingData& missing);

}  // namespace armtune::internal
