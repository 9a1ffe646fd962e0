#pragma once
// Builds the model of an arm from the complete content of a URDF (urdf_tree.hpp), which may also describe
// other machines.

#include <string>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_options.hpp"
#include "core/robot/urdf_tree.hpp"

namespace armtune::internal {

/// Builds the model of the arm. Throws InputError with a message that begins with `source`. With `missing`,
/// it does not throw for data that neither the file nor the options give. It lists these data in `missing`,
/// and puts placeholders of 1 into the model, which must then not be simulated.
RobotModel build_arm(const UrdfTree& tree, const UrdfOptions& options, const std::string& source,
                     MissingData* missing = nullptr);

}  // namespace armtune::internal
