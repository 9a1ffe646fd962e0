#pragma once
// Reads the key `name` of a gaze target, an obstacle or a part of the robot cell in a scenario file.

#include <string>

#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// Returns the value of the key `name`. Throws InputError, with file and line, if it is missing, or if it has
/// a character that terminals and files of results cannot show.
std::string read_name(yaml::MapReader& map);

}  // namespace armtune::internal
