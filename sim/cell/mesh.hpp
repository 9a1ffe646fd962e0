#pragma once
// The triangles of a mesh file, or the reason why they could not be read.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace armtune::internal {

struct Mesh {
  std::vector<float> corners;  ///< nine coordinates per triangle, in the unit of the file
  std::string refusal;         ///< why the mesh was not read, as a clause; empty if it was read
};

inline Mesh refused_mesh(std::string why) {
  return {{}, std::move(why)};
}

/// Refuses a mesh that has no triangles, or more than `most`. Returns any other mesh unchanged.
Mesh checked_mesh(Mesh mesh, std::size_t most);

}  // namespace armtune::internal
