#pragma once
// One number per joint, as a list in joint order or as a map by joint name.

#include "core/common/types.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::yaml {

/// n numbers. Throws InputError if a joint is missing, unknown, or the count is wrong.
JointVector joint_values(const Node& node, const std::vector<std::string>& joints);

}  // namespace armtune::yaml
