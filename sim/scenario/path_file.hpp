#pragma once
// Reads the paths of tool, targets and obstacles from scenario files. A path is a named curve (such as a
// circle), a polyline, a spline through waypoints, or a sum of harmonics.

#include <string>
#include <vector>

#include "sim/scenario/scenario.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

// clang-format off
/// Reads one of these, in the base frame:
///
///   circle: {center, radius, period, normal: [0, 0, 1], start_deg: 0}
///   ellipse: {center, axis_1, axis_2, period, start_deg: 0}
///       semi-axes as vectors; the motion goes from the first to the second
///   figure_eight: {center, length, width, period, start_deg: 0}
///       half the length and half the width as vectors; the motion begins in the middle
///   hold: [x, y, z]
///   polyline: {corners: [[x, y, z], ...], speed, blend, closed: false}
///       straight lines; each corner is rounded from `blend` before it to `blend` after it (polyline.hpp)
///   waypoints: FILE.csv
///       columns time, x, y, z: the cubic spline through them, at rest at both ends (waypoints_file.hpp)
///   waypoints: {file: FILE.csv, units: {time: ms, length: mm}, columns: [time, x, y, z]}
///   center, frequency, phase, terms: [{order, cos, sin}]
///       a sum of harmonics (path.hpp)
///
/// start_deg is the point of the curve where the motion begins; 360 degrees are one lap. File names are
/// relative to the folder of the file that contains them. The names of waypoint files that this reads are
/// added to `inputs`. of_poses: true if a waypoint file may also have the columns of the tool's orientation.
/// Throws InputError with file, line and key.
// clang-format on
Path read_path(yaml::MapReader& map, std::vector<std::string>& inputs, bool of_poses = false);

}  // namespace armtune::internal
