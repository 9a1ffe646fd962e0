#pragma once
// A path along straight sides between corners, at constant speed. At each corner a quintic, the blend, leads
// from one side to the next. It starts at the distance `blend` before the corner, ends at the same distance
// after it, and takes the time 2 * blend / speed. The acceleration is zero at both ends of the quintic, so
// velocity and acceleration do not jump. (Siciliano et al., Robotics: Modelling, Planning and Control,
// section 4.2.2, with quintics in place of parabolas.)

#include <vector>

#include "core/trajectory/position_spline.hpp"

namespace armtune::internal {

/// Returns the motion around the corners. corners [m]: no corner equals the next one. speed [m/s] and blend
/// [m]: above zero. closed: true if the path returns from the last corner to the first and repeats. Otherwise
/// the motion starts and ends at rest at the first and the last corner, and speeds up and slows down over the
/// distance `blend`. Throws InputError, naming the corners or values, if a side is too short for the blends
/// at its ends or an argument is not valid.
PositionSpline polyline(const std::vector<Vec3>& corners, double speed, double blend, bool closed);

}  // namespace armtune::internal
