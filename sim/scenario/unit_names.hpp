#pragma once
// Column names of users' tables that are followed by a unit: "x [mm]", "time (s)".

#include <string>

#include "sim/yaml/file_units.hpp"

namespace armtune::internal {

/// Returns the line of column names of a table, separated by commas, as armtune calls its columns: without
/// units, and with time as `time`. path: for messages. Throws InputError for a unit that contradicts `units`.
/// An unknown unit beside known ones is an error too, because its column would otherwise be ignored silently.
std::string plain_names(const std::string& line, const std::string& path, const yaml::FileUnits& units);

}  // namespace armtune::internal
