#pragma once
// The triangles of a binary STL file.

#include <optional>
#include <string>
#include <vector>

namespace armtune::internal {

/// Nine coordinates per triangle, as the file has them. Nothing if it cannot be read, is no binary STL (a
/// text one, COLLADA), its size is not that of its triangles, a coordinate is not finite, or it has more than
/// `most` triangles.
std::optional<std::vector<float>> read_binary_stl(const std::string& path, std::size_t most);

}  // namespace armtune::internal
