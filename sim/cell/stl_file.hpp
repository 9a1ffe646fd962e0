#pragma once
// Reads the triangles of a binary STL file, such as the mesh of a link.

#include <optional>
#include <string>
#include <vector>

namespace armtune::internal {

/// Reads the file with read_input_file and returns nine coordinates per triangle, in the order of the file.
/// Returns nothing if the file cannot be read, is not a binary STL file (but for example a text STL or a
/// COLLADA file), or has a size that does not match its number of triangles. Also returns nothing if a
/// coordinate is not finite, if there are no triangles, or if there are more than `most` triangles.
std::optional<std::vector<float>> read_binary_stl(const std::string& path, std::size_t most);

}  // namespace armtune::internal
