#include "sim/cell/mesh.hpp"

#include <fmt/format.h>

namespace armtune::internal {

Mesh checked_mesh(Mesh mesh, std::size_t most) {
  if (mesh.corners.size() > 9 * most) return refused_mesh(fmt::format("it has more than {} triangles", most));
  if (mesh.corners.empty()) return refused_mesh("it has no triangles");
  return mesh;
}

}  // namespace armtune::internal
