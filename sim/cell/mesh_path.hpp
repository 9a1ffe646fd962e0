#pragma once
// Finds the file of a mesh that a URDF refers to, and checks that armtune may read it. A URDF from a stranger
// must not make armtune read arbitrary files.

#include <optional>
#include <string>

namespace armtune::internal {

/// The environment variable that lists further folders from which meshes may be read, in addition to the
/// robot's own. They are separated as in PATH. An entry NAME=FOLDER is the package of that name.
inline constexpr const char* kMeshFolders = "ARMTUNE_MESHES";

/// Returns the file that a URDF refers to by `package://NAME/x`, by `file://x` or by a path from the URDF's
/// folder. For a package, x lies below a folder that contains the URDF and is called NAME, by its own name or
/// in its package.xml, or below one called NAME in an allowed folder.
///
/// A URDF may come from a stranger, and the files that it names appear in reports. Therefore this returns
/// nothing unless the file, with links followed, is within the robot's folder or an allowed one. The robot's
/// folder is the nearest one above the URDF with a package.xml. Without any, it is the URDF's own folder, or
/// the one above if the URDF's is called `urdf`. The folder of the package is allowed as well.
std::optional<std::string> mesh_path(const std::string& named, const std::string& urdf);

}  // namespace armtune::internal
