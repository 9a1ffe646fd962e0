#pragma once
// The shapes of a URDF link.

#include <vector>

#include "core/robot/shape.hpp"

namespace urdf {
class Link;
}

namespace armtune::internal {

/// What the link shows, then what it collides with, in the link's frame. Shapes without a positive finite
/// size are left out: they are for drawing only.
std::vector<Shape> shapes_of(const urdf::Link& link);

}  // namespace armtune::internal
