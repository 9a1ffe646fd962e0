#pragma once
// Reads a table of numbers from a user's CSV file. Its cells are separated by commas, semicolons, tabs or
// blanks. A scenario that refers to the file can declare units other than SI, and the names of the columns if
// the file has other names or none.

#include <string>
#include <vector>

#include "sim/csv/csv_table.hpp"
#include "sim/yaml/file_units.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// The path of a table, with its units and column names.
struct UserTable {
  std::string path;
  yaml::FileUnits units = {};
  /// Column names that replace the names in the file, or supply them if the file has none. Empty: the names
  /// in the file are used.
  std::vector<std::string> columns = {};
  bool has_units = false;  ///< true if units were declared

  /// Returns true if units or columns were given.
  bool is_described() const { return has_units || !columns.empty(); }
};

/// Reads the keys `file`, `units` and `columns` of a map. The caller reads the map's other keys. The path in
/// `file` is relative to the folder of the file that contains the map. units: the kinds of units that may be
/// declared, such as "time angle" (read_file_units). Throws InputError with file, line and key.
UserTable read_user_table(yaml::MapReader& map, const char* units);

/// The contents of the file, and its name in messages.
struct ParsedTable {
  CsvTable table;
  std::string name;
};

/// The treatment of column names: they are read as written, or converted to lower case.
enum class ColumnNames { kAsWritten, kInLowerCase };

/// Reads the file. key, columns: how a scenario would name the file and its columns ("waypoints", "time, x,
/// y, z"), for the message about a file without column names. Throws InputError with file and line.
ParsedTable parse_user_table(const UserTable& file, ColumnNames names, const std::string& key,
                             const std::string& columns);

/// Returns column `time` in seconds; see rising_times.
std::vector<double> rising_seconds(const ParsedTable& parsed, const UserTable& file);

}  // namespace armtune::internal
