#pragma once
// Reads the units that a user declares for the numbers in a CSV file, such as {time: ms, length: mm}, and
// returns the factors that convert these numbers to SI units.

#include "armtune/error.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal::yaml {

/// The factors that convert the numbers of a table to SI units.
struct FileUnits {
  double time = 1.0;
  double length = 1.0;
  double angle = 1.0;
  double torque = 1.0;
};

/// Reads {time: s, ms, us or ns, length: m, cm, mm or in, angle: rad or deg, torque: N m or mN m}. If a key
/// is left out, its SI unit applies. allowed: the keys that may be given, with blanks between them. Throws
/// InputError with file, line and key for any other key or unit.
FileUnits read_file_units(const Node& node, const char* allowed);

/// Compares the unit of a column with the declared ones. Returns true if `unit` agrees with `units`, and
/// false if read_file_units does not accept `unit`. Throws InputError with the place `column` if `unit`
/// contradicts `units`.
bool check_unit(const std::string& unit, const FileUnits& units, const InputPlace& column);

}  // namespace armtune::internal::yaml
