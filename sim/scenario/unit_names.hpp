#pragma once
// Removes the units from column names of users' tables, such as "x [mm]" and "time (s)", and checks that they
// agree with the units that the user declared.

#include <string>

#include "sim/yaml/file_units.hpp"

namespace armtune::internal {

/// Returns a line of column names, separated by commas, with armtune's names: without units, and with `time`
/// for the time. path: for messages. Throws InputError for a unit that contradicts `units`, and for an
/// unknown unit beside known ones, because its column would otherwise be ignored silently.
std::string plain_names(const std::string& line, const std::string& path, const yaml::FileUnits& units);

}  // namespace armtune::internal
