#pragma once
// Finds data files: robots, scenarios, gains and studies. Files that are installed with armtune (bundled) are
// found by name, and the user's own files by path.

#include <string>
#include <vector>

namespace armtune::internal {

/// Returns the path of the file `name_or_path`. A text with a '/' or with the extension of a data or robot
/// file (such as .yaml or .urdf) is a path. Any other text is the name of a bundled file in `folder`
/// ("robots", "scenarios", "gains", "studies"). relative_to: the folder in which a relative path is tried
/// first, for example the folder of the file that contains the path; may be empty. Throws InputError if there
/// is no such file. If a name was given, the message lists the bundled files.
std::string find_data_file(const std::string& folder, const std::string& name_or_path,
                           const std::string& relative_to = {});

/// Returns the names of the bundled files of a folder, sorted.
std::vector<std::string> bundled_names(const std::string& folder);

/// Returns the folder with the bundled data. This is $ARMTUNE_DATA if it is set. Otherwise it is
/// share/armtune beside the folder of the program or, if that has no data, the folder where the data was
/// installed. Throws InputError if the data is not there.
std::string data_folder();

/// Returns a reference by which another machine finds the same file: the name of a bundled file, or the
/// absolute path of any other file. Throws InputError if that path is not UTF-8.
std::string portable_reference(const std::string& path);

/// True if a full path is in the folder with the bundled data.
bool is_bundled(const std::string& path);

/// Returns the path for a person to read. Bundled files are shown without the folder of their installation.
std::string shown_path(const std::string& path);

/// Returns the full path of a file that another file, `named_in`, refers to by `path`. A relative path starts
/// in the folder of `named_in`.
std::string file_beside(const std::string& path, const std::string& named_in);

/// Returns the file name without folder and extension.
std::string stem(const std::string& path);
/// Returns the folder part of a path, "." if it has none.
std::string folder_of(const std::string& path);

}  // namespace armtune::internal
