#pragma once
// Checks whether a file or folder exists at a path. If that cannot be determined, an InputError gives the
// reason. A folder without read permission is therefore never mistaken for a missing one.

#include <string>

namespace armtune::internal {

/// True if a file, folder or anything else exists there; symbolic links are followed. Throws
/// InputError with path and reason if that cannot be determined, for example because a folder of the path may
/// not be entered, links form a loop, or the name is too long.
bool is_there(const std::string& path);

/// Throws InputError if something, even a broken link, exists at the path, or if that cannot be determined.
/// It is for files that are never overwritten.
void refuse_existing(const std::string& path);

/// True if the folder is missing or contains nothing but empty folders, such as those that a run leaves if
/// the disk is full. Throws InputError with path and reason if that cannot be determined: a folder may not be
/// read, too many files are open, or the path is not that of a folder.
bool is_missing_or_empty(const std::string& folder);

}  // namespace armtune::internal
