#pragma once
// A user's table as CSV: commas, semicolons, tabs or blanks separate its cells. Other units than SI, and the
// columns of a file without a line of names or with others, are said where the file is named.

#include <string>
#include <vector>

#include "sim/csv/csv_table.hpp"
#include "sim/yaml/file_units.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {

/// A file, and what its numbers are.
struct UserTable {
  std::string path;
  yaml::FileUnits units = {};
  /// In place of the file's line of names, if it has one; empty: as that says.
  std::vector<std::string> columns = {};
  bool has_units = false;  ///< units were given

  /// Returns true if anything was said of its numbers.
  bool is_described() const { return has_units || !columns.empty(); }
};

/// Reads the keys file, units and columns of a map, whose other keys are the caller's. The path is from the
/// folder of the file that names it. units: the kinds that may be given, as read_file_units has them. Throws
/// InputError with file, line and key.
UserTable read_user_table(yaml::MapReader& map, const char* units);

/// What stands in the file, and what messages call it.
struct ParsedTable {
  CsvTable table;
  std::string name;
};

/// How a line of names is read.
enum class ColumnNames { kAsWritten, kInLowerCase };

/// Reads the file. key, columns: how a scenario would name it and its columns ("waypoints", "time, x, y, z"),
/// for the message about a file without a line of names. Throws InputError with file and line.
ParsedTable parse_user_table(const UserTable& file, ColumnNames names, const std::string& key,
                             const std::string& columns);

/// Returns column `time` in seconds; see rising_times.
std::vector<double> rising_seconds(const ParsedTable& parsed, const UserTable& file);

}  // namespace armtune::internal
