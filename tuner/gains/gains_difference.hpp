#pragma once
// Compares gain sets side by side and shows what differs.

#include <string>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune::internal {

struct NamedGains {
  std::string name;
  Gains gains;
};

/// Returns a table of every number and switch that is not the same in all sets, with its unit and the ratio
/// to the first set. '-' marks a gain that a set's controller does not have. A last line gives how many
/// values are equal in all sets. sets: at least one. joints: names of the joints of the arm that all sets are
/// for.
std::string gains_difference(const std::vector<NamedGains>& sets, const std::vector<std::string>& joints);

}  // namespace armtune::internal
