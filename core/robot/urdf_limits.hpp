#pragma once
// The position, velocity and effort limits of a joint. They come from the URDF. The options for reading it
// can replace them, or add limits that the file lacks.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_selection.hpp"

namespace armtune::internal {

/// Returns the joint's limits; those of the options replace those of the file. If `missing` is given, missing
/// limits are added to it and replaced by 1 (positions: -1 to 1) [rad, m, rad/s, m/s, N m, N]. Otherwise,
/// missing position limits throw InputError with a message that begins with `source`.
JointLimits limits_of(const UrdfJoint& joint, const UrdfOptions& options, const std::string& source,
                      MissingData* missing);

/// Returns the position within the joint's limits that is closest to zero [rad, m]. Messages propose it for a
/// joint that must be held.
double place_to_hold(const UrdfJoint& joint, const UrdfOptions& options);

}  // namespace armtune::internal
