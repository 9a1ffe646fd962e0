#pragma once
// What the file system says about a path. Where it cannot say, an InputError tells why, so that a folder that
// may not be read is never taken for a missing one.

#include <string>

namespace armtune::internal {

/// Returns true if a file, folder or anything else is there; symbolic links are followed. Throws InputError
/// with path and reason where that cannot be told: a folder on the way may not be searched, links form a
/// loop, or the name is too long.
bool is_there(const std::string& path);

/// Throws InputError if something is at the path already, a broken link too, or if that cannot be told. For
/// files that are never overwritten.
void refuse_existing(const std::string& path);

/// Returns true if the folder is missing or holds nothing. Throws InputError with path and reason if that
/// cannot be told: it may not be read, too many files are open, or it is no folder.
bool is_missing_or_empty(const std::string& folder);

}  // namespace armtune::internal
