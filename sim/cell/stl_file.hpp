#pragma once
// Reads the triangles of a binary STL file, such as the mesh of a link.

#include <optional>
#include <string>
#include <vector>

namespace armtune::internal {

/// Returns nine coordinates per triangle, as in the file, which is read by read_input_file. Returns nothing
/// if the file cannot be read, is not a binary STL (a text one, COLLADA), has a size that does not match its
/// triangles, has a coordinate that is not finite, has no triangles, or has more than `most`.
std::optional<std::vector<float>> read_binary_stl(const std::string& path, std::size_t most);

}  // namespace armtune::internal
