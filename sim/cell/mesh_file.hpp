#pragma once
// Reads the mesh files that URDFs name: STL, binary or text, and OBJ.

#include <cstddef>
#include <string>

#include "sim/cell/mesh.hpp"

namespace armtune::internal {

/// Reads a mesh with read_input_file. A file whose name ends with .obj is read as OBJ. A file whose name ends
/// with .dae or .glb, for example, is refused with advice to convert it. Every other file is read as STL,
/// binary if its size matches its number of triangles, and otherwise text. A file may have 32 MB or, if that
/// is more, the size of a binary STL file with `most` triangles. A mesh with more than `most` triangles is
/// refused.
Mesh read_mesh(const std::string& path, std::size_t most);

}  // namespace armtune::internal
