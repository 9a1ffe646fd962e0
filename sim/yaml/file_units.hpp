#pragma once
// The units of the numbers in a user's table.

#include "sim/yaml/document.hpp"

namespace armtune::internal::yaml {

/// Factors that make the numbers of a table SI.
struct FileUnits {
  double time = 1.0;
  double length = 1.0;
  double angle = 1.0;
  double torque = 1.0;
};

/// {time: s, ms, us or ns, length: m, cm, mm or in, angle: rad or deg, torque: N m or mN m}. A key that is
/// left out stands for SI. Throws InputError with file, line and key for any other key, and for those that
/// `allowed` does not name: a list of keys with blanks between them.
FileUnits read_file_units(const Node& node, const char* allowed);

/// Throws InputError that begins with `where` for a unit of a column that the file's `units` contradict.
/// False: `unit` is none of those that read_file_units knows.
bool check_unit(const std::string& unit, const FileUnits& units, const std::string& where);

}  // namespace armtune::internal::yaml
