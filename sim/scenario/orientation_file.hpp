#pragma once
// The reader of the key `orientation` of scenario files, which gives the orientation of the tool directly, in
// place of a gaze at a target.

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
///   along_path: [x, y, z]         the tool's x axis where the path goes, its z axis as near to this as can be
///   waypoints: FILE.csv           columns time, qw, qx, qy, qz: the spline through them, at rest at both ends
///
/// path: the tool's path in the same scenario. Files are named from the folder of the file that names them,
/// and added to `inputs`. Throws InputError with file, line and key. With along_path it also throws, with the
/// time, where the path stops or reverses, or runs along the direction that z is to be near.
// clang-format on
ToolOrientation read_orientation(const yaml::Node& node, const Path& path, std::vector<std::string>& inputs);

}  // namespace armtune::internal
