#pragma once
// Builds the model of an arm from the complete content of a URDF (urdf_tree.hpp), which may also describe
// other machines.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_options.hpp"
#include "core/robot/urdf_tree.hpp"

namespace armtune::internal {

/// Builds the model of the arm. Throws InputError with a message that begins with `source`. If `missing` is
/// given, data that neither file nor options give are collected there, instead of throwing. The model then
/// has placeholders of 1 in their place and must not be simulated.
RobotModel build_arm(const UrdfTree& tree, const UrdfOptions& options, const std::string& source,
                     MissingData* missing = nullptr);

}  // namespace armtune::internal
