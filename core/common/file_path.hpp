#pragma once
// Simplifies the path of a file or makes it absolute. The result still names the same file.

#include <string>

namespace armtune::internal {

/// Returns the path without "." and, if the result still names the same file, without "..". After a symbolic
/// link ".." is kept, because there it means the parent of the link's target, not the folder that contains
/// the link. Returns "." for an empty path.
std::string without_dots(const std::string& path);

/// Returns the simplified path as an absolute path. Throws InputError if the current folder, where relative
/// paths begin, was deleted or may not be accessed.
std::string absolute_path(const std::string& path);

}  // namespace armtune::internal
