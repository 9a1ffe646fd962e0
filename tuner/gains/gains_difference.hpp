#pragma once
// Gain sets side by side: what differs.

#include <string>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune::internal {

struct NamedGains {
  std::string name;
  Gains gains;
};

/// A table of every number and switch in which the sets are not the same, with its unit and each set's ratio
/// to the first;
/// '-' where a set's controller has no such gain, and below it how many are the same in all. At least one
/// set. `joints`: the names of the arm's, which all sets are for.
std::string gains_difference(const std::vector<NamedGains>& sets, const std::vector<std::string>& joints);

}  // namespace armtune::internal
