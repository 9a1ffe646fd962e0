#pragma once
// A user's table as CSV. Its cells are separated by commas, semicolons, tabs or blanks. Units other than SI
// are declared where the file is named. So are the columns of a file with other column names, or with none.

#include <string>
#include <vector>

#include "sim/csv/csv_table.hpp"
#include "sim/yaml/file_units.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// A file, and the meaning of its numbers.
struct UserTable {
  std::string path;
  yaml::FileUnits units = {};
  /// Column names in place of the file's own line of names, if it has one. Empty: the file's own names.
  std::vector<std::string> columns = {};
  bool has_units = false;  ///< units were given

  /// Returns true if units or columns were given.
  bool is_described() const { return has_units || !columns.empty(); }
};

/// Reads the keys file, units and columns of a map. The caller reads the map's other keys. The path is
/// relative to the folder of the file that names it. units: the kinds that may be given, as in
/// read_file_units. Throws InputError with file, line and key.
UserTable read_user_table(yaml::MapReader& map, const char* units);

/// The contents of the file, and its name in messages.
struct ParsedTable {
  CsvTable table;
  std::string name;
};

/// The case in which a line of column names is read.
enum class ColumnNames { kAsWritten, kInLowerCase };

/// Reads the file. key, columns: how a scenario would name the file and its columns ("waypoints", "time, x,
/// y, z"), for the message about a file without column names. Throws InputError with file and line.
ParsedTable parse_user_table(const UserTable& file, ColumnNames names, const std::string& key,
                             const std::string& columns);

/// Returns column `time` in seconds; see rising_times.
std::vector<double> rising_seconds(const ParsedTable& parsed, const UserTable& file);

}  // namespace armtune::internal
