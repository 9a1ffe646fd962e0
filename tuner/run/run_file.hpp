#pragma once
// Finds files in a run's folder safely. A run folder may come from somebody else. Names in its files, such as
// a scenario's in scene.json, become names of further files. None of them may lead out of the folder.

#include <optional>
#include <string>

namespace armtune::internal {

/// Returns the path of a file in a run's folder, or nothing if there is none. name: below the folder, such as
/// "start/errors.csv". The folder itself may be reached by a symbolic link, because the user named it. Throws
/// InputError naming the file if the name leads out of the folder, if the file or a folder on the way to it
/// is a symbolic link, or if it is not a regular file: a pipe, for example, may have no end.
std::optional<std::string> find_run_file(const std::string& folder, const std::string& name);

/// Returns the same, but throws InputError if there is no such file.
std::string run_file(const std::string& folder, const std::string& name);

/// Throws InputError naming a symbolic link if there is one anywhere in a run's folder. Call it before
/// writing into a folder that may come from somebody else: behind a link every file would be made elsewhere.
/// The folder itself may be reached by a link.
void refuse_links(const std::string& folder);

}  // namespace armtune::internal
