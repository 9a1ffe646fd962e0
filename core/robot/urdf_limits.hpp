#pragma once
// A joint's limits, from its URDF and from what a robot file says in its place.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_selection.hpp"

namespace armtune::internal {

/// The options' in place of the file's. missing: where given, what is missing is added to it and stands as 1
/// (positions: -1 to 1) [rad, m, rad/s, m/s, N m, N]; without it, missing position limits throw InputError,
/// with `source` in front.
JointLimits limits_of(const UrdfJoint& joint, const UrdfOptions& options, const std::string& source,
                      MissingData* missing);

/// Within the joint's limits, as close to zero as they allow [rad, m].
double place_to_hold(const UrdfJoint& joint, const UrdfOptions& options);

}  // namespace armtune::internal
