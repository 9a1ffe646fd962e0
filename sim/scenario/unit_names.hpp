#pragma once
// Removes the units from column names of users' tables, such as "x [mm]" and "time (s)", and checks that they
// agree with the units that the user declared.

#include <string>

#include "sim/yaml/file_units.hpp"

namespace armtune::internal {

/// Returns the column names of `line`, separated by commas, without their units. The column of the time gets
/// the name `time` if it is called time, t or time_from_start in capital or small letters. path: name of the
/// file in messages. Throws InputError for a unit that contradicts `units`. Also throws InputError if some
/// columns have known units and one has an unknown unit, because that column would otherwise be ignored
/// silently.
std::string plain_names(const std::string& line, const std::string& path, const yaml::FileUnits& units);

}  // namespace armtune::internal
