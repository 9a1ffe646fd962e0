#pragma once
// Reads the triangles of an STL file, such as the mesh of a link. STL has two forms: a binary form, and a
// text form that is also called ASCII STL.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/cell/mesh.hpp"

namespace armtune::internal {

/// Returns the mesh in the bytes of a binary STL file, with its triangles in the order of the file. Returns
/// nothing if the number of triangles that the file gives does not match its size: such a file is not binary
/// STL. The mesh is refused if a coordinate is not finite, if there are no triangles, or if there are more
/// than `most`.
std::optional<Mesh> binary_stl(std::string_view bytes, std::size_t most);

/// Returns the mesh in the text of an ASCII STL file, with its triangles in the order of the file. Normals
/// and names are ignored. The mesh is refused, with the line, if the text departs from the form `solid`,
/// `facet`, `outer loop`, three times `vertex`, `endloop`, `endfacet`, `endsolid`, or if a coordinate is not
/// a finite number. It is also refused if there are no triangles, or more than `most`.
Mesh text_stl(std::string_view text, std::size_t most);

}  // namespace armtune::internal
