#pragma once
// Where a mesh lies that a URDF names, and whether it may be read.

#include <optional>
#include <string>

namespace armtune::internal {

/// Folders beside the robot's own from which meshes may be read, as in PATH: `ARMTUNE_MESHES`. One that is
/// written NAME=FOLDER is the package of that name.
inline constexpr const char* kMeshFolders = "ARMTUNE_MESHES";

/// The file that a URDF means by `package://NAME/x` (x below the folder that holds the URDF and is called
/// NAME, or so named by its package.xml, or below one called NAME in an allowed folder), `file://x` or a path
/// from the URDF's folder. A URDF may come from a stranger, and what it names is put into reports: nothing
/// unless it is a file within the robot's folder (the nearest one above the URDF with a package.xml; where
/// there is none the URDF's own, or the one that holds its `urdf`) or an allowed one, links followed.
std::optional<std::string> mesh_path(const std::string& named, const std::string& urdf);

}  // namespace armtune::internal
