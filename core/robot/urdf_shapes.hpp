#pragma once
// The shapes of a URDF link.

#include <vector>

#include "core/robot/shape.hpp"

namespace urdf {
class Link;
}

namespace armtune {

/// Appends what the link shows, then what it collides with. body, R_BL, p_BL [m]: where
/// the link's frame L sits. Shapes without a positive finite size are left out: they are for drawing only.
void append_shapes(const urdf::Link& link, int body, const Mat3& R_BL, const Vec3& p_BL,
                   std::vector<Shape>& shapes);

}  // namespace armtune
