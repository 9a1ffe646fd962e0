#pragma once
// Bundled robots, scenarios, gains and studies: found by name; the user's own files: found by path.

#include <string>
#include <vector>

namespace armtune::internal {

/// Path of `name_or_path`: a path if it holds a '/' or the extension, else the bundled file of that name in
/// `folder` ("robots", "scenarios", "gains", "studies"). `relative_to`: folder that relative paths are also
/// tried in (that of the file which names it), may be empty. Throws InputError that lists what is bundled.
std::string find_data_file(const std::string& folder, const std::string& name_or_path,
                           const std::string& relative_to = {});

/// Names of the bundled files of a folder, sorted.
std::vector<std::string> bundled_names(const std::string& folder);

/// Folder that holds the bundled data: $ARMTUNE_DATA, else share/armtune beside the program's bin/, else
/// where it was installed. Throws InputError if none is there.
std::string data_folder();

/// How another machine finds the same file: the bundled name where it is bundled, else the absolute path.
/// Throws InputError where that is not UTF-8.
std::string portable_reference(const std::string& path);

/// The path for a person to read: bundled files without the folder they happen to be installed in.
std::string shown_path(const std::string& path);

/// A file's path, from the folder of the file that names it.
std::string file_beside(const std::string& path, const std::string& named_in);

/// File name without folder and extension.
std::string stem(const std::string& path);
/// Folder part of a path, "." if it has none.
std::string folder_of(const std::string& path);

}  // namespace armtune::internal
