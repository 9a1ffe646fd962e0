#pragma once
// Reads the visual and collision shapes of a URDF link.

#include <vector>

#include "core/robot/shape.hpp"

namespace urdf {
class Link;
}

namespace armtune::internal {

/// Returns the link's visual shapes, then its collision shapes, in the link's frame. A visual shape without a
/// positive finite size is left out; a collision shape without one gets the kind kNoSize.
std::vector<Shape> shapes_of(const urdf::Link& link);

}  // namespace armtune::internal
