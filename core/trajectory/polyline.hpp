#pragma once
// Straight ways between corners at one speed, the corners blended by quintics: from `blend` before a corner
// to `blend` behind it in the time that this length takes at that speed, with no acceleration at either end,
// so that velocity and acceleration have no jumps. (Siciliano et al., Robotics: Modelling, Planning and
// Control, section 4.2.2, with quintics in place of parabolas.)

#include <vector>

#include "core/trajectory/position_spline.hpp"

namespace armtune::internal {

/// corners [m], no two the same in a row; speed [m/s] and blend [m], both above zero. closed: from the last
/// corner back to the first, for ever; otherwise it starts and ends at rest at the outer corners, where it
/// speeds up and slows down over `blend`. Throws InputError naming the corner if a side is too short for the
/// blends at its ends, or what else is wrong.
PositionSpline polyline(const std::vector<Vec3>& corners, double speed, double blend, bool closed);

}  // namespace armtune::internal
