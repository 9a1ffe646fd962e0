#pragma once
// Reads the key `cell` of scenario and robot files. The key describes the surroundings of the arm (floor and
// convex parts), which the arm must not touch.

#include <string>
#include <vector>

#include "sim/cell/cell.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

/// Reads {floor: HEIGHT, parts: [{name, a shape of solid_keys.hpp, rpy_deg, a path of path_file.hpp}, ...]}.
///
/// The floor's height is measured from the base frame's origin, opposite to gravity [m]. The path moves the
/// part's centre; a part at rest has the key `center` alone. The names of waypoint files that this reads are
/// added to `inputs`. Throws InputError with file, line and key.
Cell read_cell(const yaml::Node& node, std::vector<std::string>& inputs);

}  // namespace armtune::internal
