#pragma once
// How thick links are: for the distance of capsules about them from obstacles.

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// Radius [m] of each link (n) out of its simple shapes, those that it collides with where it has any: the
/// largest of its cylinders, capsules and spheres, of a box the half diagonal across its longest edge. NaN
/// where there is none, as of meshes. Where a shape lies does not count: one aside of the straight line
/// between the joints' origins sticks out of the capsule about it.
JointVector shape_radii(const RobotModel& model);

/// The same arm, whose distance from obstacles is that of capsules about its links: straight from each
/// joint's origin to the next one's, the last one's to the tool's, as thick as model.link_radii says. Throws
/// InputError naming the links whose radius is not known.
RobotModel with_link_surfaces(const RobotModel& model);

}  // namespace armtune::internal
