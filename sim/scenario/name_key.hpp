#pragma once
// Reads the key `name` of a gaze target, an obstacle or a part of the robot cell in a scenario file.

#include <string>

#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// Returns the value of the key `name`. Throws InputError, with file and line, if the name is missing or
/// empty, or if it contains a character that is not printable (see is_printable).
std::string read_name(yaml::MapReader& map);

}  // namespace armtune::internal
