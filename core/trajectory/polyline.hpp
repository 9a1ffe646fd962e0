#pragma once
// A path of straight sides between corners at one speed, with corners blended by quintics. A blend starts
// `blend` before a corner, ends `blend` after it, and takes the time 2 blend / speed. The acceleration is
// zero at both of its ends, so velocity and acceleration do not jump. (Siciliano et al., Robotics: Modelling,
// Planning and Control, section 4.2.2, with quintics in place of parabolas.)

#include <vector>

#include "core/trajectory/position_spline.hpp"

namespace armtune::internal {

/// Returns the motion through the corners. corners [m]: successive ones differ. speed [m/s] and blend [m]:
/// above zero. closed: the path returns from the last corner to the first and repeats. Otherwise it starts
/// and ends at rest at the outer corners, and speeds up and slows down over `blend`. Throws InputError,
/// naming the corners or values, if a side is too short for the blends at its ends or an argument is not
/// valid.
PositionSpline polyline(const std::vector<Vec3>& corners, double speed, double blend, bool closed);

}  // namespace armtune::internal
