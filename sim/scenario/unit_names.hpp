#pragma once
// Names of columns with a unit behind them, as users' tables have them: "x [mm]", "time (s)".

#include <string>

#include "sim/yaml/file_units.hpp"

namespace armtune::internal {

/// Returns the line of names of a table, with commas between them, as armtune calls its columns: without
/// units, and time as `time`. path: for messages. Throws InputError for a unit that contradicts `units`, and
/// for an unknown one beside known ones, whose column would otherwise be left out without a word.
std::string plain_names(const std::string& line, const std::string& path, const yaml::FileUnits& units);

}  // namespace armtune::internal
