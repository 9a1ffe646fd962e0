#pragma once
// Checks the gains of a controller: every value must be within its limits, and the length of vectors must fit
// the number of joints.

#include <string>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune::internal {

/// Checks all gains of the controller that `gains` names. Throws InputError naming the gain, its value and
/// the limit; the message begins with `source`.
void validate(const Gains& gains, const std::vector<std::string>& joints, const std::string& source);

}  // namespace armtune::internal
