#pragma once
// The units that a user declares for the numbers in a table, and their conversion to SI.

#include "sim/yaml/document.hpp"

namespace armtune::internal::yaml {

/// The factors that convert the numbers of a table to SI units.
struct FileUnits {
  double time = 1.0;
  double length = 1.0;
  double angle = 1.0;
  double torque = 1.0;
};

/// Reads {time: s, ms, us or ns, length: m, cm, mm or in, angle: rad or deg, torque: N m or mN m}. A key that
/// is left out stands for SI. allowed: the keys that may be given, with blanks between them. Throws
/// InputError with file, line and key for any other key.
FileUnits read_file_units(const Node& node, const char* allowed);

/// Returns true if `unit`, the unit of a column, is one that read_file_units accepts and agrees with `units`,
/// and false if it is not such a unit. Throws InputError that begins with `where` if it contradicts `units`.
bool check_unit(const std::string& unit, const FileUnits& units, const std::string& where);

}  // namespace armtune::internal::yaml
