#pragma once
// Reads one number per joint from YAML: from a list in joint order, or from a map by joint name.

#include "armtune/error.hpp"
#include "core/common/types.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal::yaml {

/// The error for values that belong to other joints than the expected ones, for example because the file
/// describes another arm.
class OtherJoints : public InputError {
 public:
  explicit OtherJoints(const InputError& error) : InputError(error) {}
};

/// Returns n numbers in joint order. Throws OtherJoints if a joint is missing or unknown, or the count is
/// wrong, and InputError for a value that is not a number.
JointVector joint_values(const Node& node, const std::vector<std::string>& joints);

}  // namespace armtune::internal::yaml
