#pragma once
// The one way from a run's folder to a file in it. A run folder may come from somebody else, and names in its
// files, such as a scenario's in scene.json, become names of further files: none of them leads elsewhere.

#include <optional>
#include <string>

namespace armtune::internal {

/// Returns the path of a file in a run's folder, or nothing where there is none. name: below the folder, such
/// as "start/errors.csv". The folder itself may be reached by a symbolic link, as the user named it. Throws
/// InputError naming the file if the name leads out of the folder, if the file or a folder on the way to it
/// is a symbolic link, or if it is no regular file: a pipe, for one, would have no end.
std::optional<std::string> find_run_file(const std::string& folder, const std::string& name);

/// Returns the same, and throws InputError where there is no such file.
std::string run_file(const std::string& folder, const std::string& name);

/// Throws InputError naming a symbolic link if there is one anywhere in a run's folder. For whoever goes on
/// writing into a folder that may come from somebody else: behind a link every file would be made elsewhere.
/// The folder itself may be reached by a link.
void refuse_links(const std::string& folder);

}  // namespace armtune::internal
