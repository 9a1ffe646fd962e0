#pragma once
// The radii of capsules around the links of an arm. Scenarios use them to measure the distance of obstacles
// from whole links instead of from the joints' origins.

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Returns the radius [m] of each link (n), from its simple collision shapes or, if it has none, its simple
/// visual shapes. It is the largest radius of the link's cylinders, capsules and spheres. A box counts with
/// half the diagonal of its cross-section perpendicular to its longest edge. The radius is NaN if the link
/// has no such shape, for example only meshes. The position of a shape is ignored: with_link_surfaces puts a
/// capsule around the straight line between the joints' origins, and a shape beside that line sticks out of
/// this capsule.
JointVector shape_radii(const RobotModel& model);

/// Returns the same arm with capsules around its links, from which the distance of obstacles is measured. The
/// axis of a capsule is the straight line from a joint's origin to the next joint's origin, or to the tool's
/// origin for the last link. The radii of the capsules are model.link_radii. Throws InputError naming the
/// links whose radius is not known.
RobotModel with_link_surfaces(const RobotModel& model);

}  // namespace armtune::internal
