#pragma once
// Finds a joint motion with which the tool of an arm follows waypoints, for controllers that follow joint
// motions.

#include "tuner/controller_study/controller_study.hpp"

namespace armtune::internal {

/// Returns a joint motion that begins at 0 s at the first waypoint. The tool follows the cubic spline through
/// the positions, at rest at both ends, within a millimetre. Where the file has orientations, the tool turns
/// through them; otherwise its orientation is free. The motion begins at the joint positions from which the
/// arm follows the waypoints best (best_start_of_task), and is found by inverse kinematics (path_walk.hpp).
/// Its acceleration is linear between its points. Throws InputError naming the file if it cannot be read, if
/// the arm cannot follow the waypoints within its position limits and without a contact, or if a joint would
/// exceed its velocity limit.
TimedGoals motion_along(const ToolWaypoints& waypoints);

}  // namespace armtune::internal
