#pragma once
// Finds the file of a mesh that a URDF refers to, and checks that armtune may read it. A URDF from a stranger
// must not make armtune read arbitrary files.

#include <optional>
#include <string>

namespace armtune::internal {

/// The environment variable that lists further folders from which meshes may be read, in addition to the
/// robot's own. An entry is FOLDER, or NAME=FOLDER for the folder of the package NAME. Colons separate the
/// entries.
inline constexpr const char* kMeshFolders = "ARMTUNE_MESHES";

/// Returns the file that a URDF refers to as `named`, which is one of these:
///   - `file://x`, or a path relative to the URDF's folder;
///   - `package://NAME/x`: the file x in a folder of the package NAME. This is a folder that contains the
///     URDF and that is called NAME, or has this name in its package.xml. It can also be an entry NAME=FOLDER
///     of kMeshFolders, or a folder called NAME in an entry FOLDER. Last, it is the folder in which ROS finds
///     the package: `share/NAME` in an entry of AMENT_PREFIX_PATH (ROS 2), or an entry of ROS_PACKAGE_PATH
///     (ROS 1) or a folder called NAME in one.
///
/// A URDF may come from a stranger, and the files that it names appear in reports. Therefore this returns
/// nothing unless the file, with symbolic links resolved, lies in one of these folders:
///   - the robot's folder, that is, the nearest folder above the URDF with a package.xml. If there is none,
///     it is the URDF's own folder, or the parent of that folder if that folder is called `urdf`;
///   - the folder of the package, if this folder contains the URDF;
///   - a folder listed in kMeshFolders;
///   - the folder in which ROS finds the package, if its package.xml has this name.
std::optional<std::string> mesh_path(const std::string& named, const std::string& urdf);

}  // namespace armtune::internal
