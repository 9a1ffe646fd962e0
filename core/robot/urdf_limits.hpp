#pragma once
// Finds the position, velocity and effort limits of a joint. They come from the URDF. The options for reading
// the URDF can replace them, or add limits that the file lacks.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_selection.hpp"

namespace armtune::internal {

/// Returns the joint's limits [rad, m, rad/s, m/s, N m, N]; those of the options replace those of the file.
/// With `missing`, each limit that the joint lacks is listed in `missing`, and becomes 1 (for positions: -1
/// to 1). Without `missing`, it throws InputError if position limits are missing; the message begins with
/// `source`.
JointLimits limits_of(const UrdfJoint& joint, const UrdfOptions& options, const std::string& source,
                      MissingData* missing);

/// Returns the position within the joint's limits that is closest to zero [rad, m]. If a joint must be held
/// at a fixed position, messages propose this one.
double place_to_hold(const UrdfJoint& joint, const UrdfOptions& options);

}  // namespace armtune::internal
