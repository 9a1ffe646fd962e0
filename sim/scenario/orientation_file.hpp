#pragma once
// Reads the key `orientation` of scenario files. It gives the desired orientation of the tool directly, for
// scenarios in which the tool does not aim at a target.

#include <string>
#include <vector>

#include "core/trajectory/tool_orientation.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

// clang-format off
/// Reads one of these, in the base frame:
///
///   rpy_deg: [roll, pitch, yaw]   fixed; about the base's x, then y, then z axis, as in a URDF
///   quaternion: [w, x, y, z]      fixed
///   along_path: [x, y, z]         tool's x axis along the path, z axis as close to [x, y, z] as possible
///   waypoints: FILE.csv           columns time, qw, qx, qy, qz: a spline through them, at rest at both ends
///
/// path: the tool's path in the same scenario. File names are relative to the folder of the file that
/// contains them. The names of waypoint files that this reads are added to `inputs`. Throws InputError with
/// file, line and key. With along_path it also throws, with the time, if the path stops or reverses, if it is
/// nearly parallel to [x, y, z], or if the tool would turn faster than 100 rad/s.
// clang-format on
ToolOrientation read_orientation(const yaml::Node& node, const Path& path, std::vector<std::string>& inputs);

}  // namespace armtune::internal
