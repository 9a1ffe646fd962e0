#pragma once
// Paths in fewer words that name the same file.

#include <string>

namespace armtune::internal {

/// The path without "." and, where that names the same file, without "..": behind a symbolic link ".." is the
/// folder above what the link names, not the one that the link is in. "." for an empty path.
std::string without_dots(const std::string& path);

/// The same, from the root of the file system. Throws InputError if the current folder, where relative paths
/// begin, was deleted or may not be looked at.
std::string absolute_path(const std::string& path);

}  // namespace armtune::internal
