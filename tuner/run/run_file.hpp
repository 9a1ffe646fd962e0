#pragma once
// Finds files in a run folder safely. A run folder may come from another person. Names in its files, such as
// the name of a scenario in scene.json, become parts of file names. No such file may lie outside the folder.

#include <optional>
#include <string>

namespace armtune::internal {

/// Returns the path of a file in a run folder, or nothing if there is no such file. name: relative to the
/// folder, such as "start/errors.csv". The folder itself may be a symbolic link, because the user named it.
/// Throws InputError naming the file
/// - if the name leads out of the folder;
/// - if the file, or a folder between the run folder and the file, is a symbolic link;
/// - if it is not a regular file, but for example a pipe, which may have no end.
std::optional<std::string> find_run_file(const std::string& folder, const std::string& name);

/// Returns the same path, but throws InputError if there is no such file.
std::string run_file(const std::string& folder, const std::string& name);

/// Throws InputError naming a symbolic link if there is one anywhere in a run folder. Call it before writing
/// into a folder that may come from another person, because files below a link would be written elsewhere.
/// The folder itself may be a symbolic link.
void refuse_links(const std::string& folder);

}  // namespace armtune::internal
