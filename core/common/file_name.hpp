#pragma once
// Names that files of results are called after: of scenarios, studies, tasks, and the labels of compared
// sets.

#include <cstddef>
#include <string>

namespace armtune::internal {

/// Longest name [byte]. A file system takes 255 for a file, and the longest that is put around a name is
/// "rollout_", ".csv" and ".partial", or a date.
inline constexpr std::size_t kLongestName = 200;

/// Throws InputError, naming `path`, if files called after `name` could not be made, or not be told of: it is
/// longer than `longest` bytes, is not UTF-8, or holds a control character or another one that ends a line.
void check_file_name(const std::string& name, const std::string& path, std::size_t longest = kLongestName);

/// The same for a name that CSV files hold as well: it holds no comma and no quote, and does not begin as a
/// spreadsheet's formula does.
void check_result_name(const std::string& name, const std::string& path, std::size_t longest = kLongestName);

}  // namespace armtune::internal
