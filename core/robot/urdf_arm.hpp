#pragma once
// The arm in a URDF.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_options.hpp"
#include "core/robot/urdf_tree.hpp"

namespace armtune::internal {

/// Throws InputError, beginning with `source`. missing, where given, collects what file and options do not
/// say instead of throwing for it; the arm then has ones in its place and is not for simulating.
RobotModel build_arm(const UrdfTree& tree, const UrdfOptions& options, const std::string& source,
                     MissingData* missing = nullptr);

}  // namespace armtune::internal
