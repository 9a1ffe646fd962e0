#pragma once
// Checks names that become part of the names of result files: the names of scenarios, studies and tasks, and
// the labels under which gain sets are compared.

#include <cstddef>
#include <string>

namespace armtune::internal {

/// Longest name [byte]. File systems allow 255 bytes for a file name. armtune adds at most "rollout_", ".csv"
/// and ".partial", or a date, to a name.
inline constexpr std::size_t kLongestName = 200;

/// Throws InputError, naming `path`, if `name` cannot be used in the names and texts of result files. Such a
/// name is longer than `longest` bytes, is not UTF-8, or contains a control character or a line separator.
void check_file_name(const std::string& name, const std::string& path, std::size_t longest = kLongestName);

/// Does the same for a name that is also written into CSV files. Such a name must also contain no comma and
/// no quote, and must not begin like a spreadsheet's formula.
void check_result_name(const std::string& name, const std::string& path, std::size_t longest = kLongestName);

}  // namespace armtune::internal
