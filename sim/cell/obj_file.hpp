#pragma once
// Reads the triangles of a Wavefront OBJ file, such as the mesh of a link.

#include <cstddef>
#include <string_view>

#include "sim/cell/mesh.hpp"

namespace armtune::internal {

/// Returns the mesh in the text of an OBJ file, with its faces in the order of the file. Only vertices (`v`)
/// and faces (`f`) are read; other lines, such as normals and materials, are ignored. A face with more than
/// three corners is divided into triangles that share its first corner. The mesh is refused, with the line,
/// if a coordinate is not a finite number, if a face has fewer than three corners, or if a face uses a vertex
/// that is not given above it. It is also refused if there are no triangles, or more than `most`.
Mesh obj_mesh(std::string_view text, std::size_t most);

}  // namespace armtune::internal
