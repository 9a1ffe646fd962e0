#pragma once
// Whether gains can be those of a controller.

#include <string>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune::internal {

/// All gains that the controller of `gains` has. Throws InputError naming the gain, its value and the limit;
/// `source` stands in front of the message.
void validate(const Gains& gains, const std::vector<std::string>& joints, const std::string& source);

}  // namespace armtune::internal
