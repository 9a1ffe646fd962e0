#pragma once
// One number per joint, as a list in joint order or as a map by joint name.

#include "armtune/error.hpp"
#include "core/common/types.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal::yaml {

/// Thrown for values of other joints than those asked for: the file may be of another arm.
class OtherJoints : public InputError {
 public:
  using InputError::InputError;
};

/// Returns n numbers. Throws OtherJoints if a joint is missing, unknown, or the count is wrong, and
/// InputError for a value that is not a number.
JointVector joint_values(const Node& node, const std::vector<std::string>& joints);

}  // namespace armtune::internal::yaml
