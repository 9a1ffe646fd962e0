#pragma once
// The model of the arm that is part of a URDF's tree.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_options.hpp"
#include "core/robot/urdf_tree.hpp"

namespace armtune::internal {

/// Builds the arm. Throws InputError, beginning with `source`. If `missing` is given, it collects the data
/// that neither file nor options give, instead of throwing for them. The arm then has placeholders of 1 in
/// their place and is not for simulation.
RobotModel build_arm(const UrdfTree& tree, const UrdfOptions& options, const std::string& source,
                     MissingData* missing = nullptr);

}  // namespace armtune::internal
