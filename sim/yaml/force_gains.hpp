#pragma once
// Gains of the obstacles' forces: one number per force point, or one list of n numbers per force point.

#include "core/control/force_gains.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal::yaml {

/// n numbers, or n x n row by row [N]. Force points stand in joint order or under their joints' names; so do
/// the numbers of each. A list of n x n plain numbers is the second form written out, as ROS 2 has no lists
/// of lists. Throws InputError with file, line and key if a joint is missing or unknown, a count is wrong, or
/// numbers and lists are mixed.
ForceGains force_gains(const Node& node, const std::vector<std::string>& joints);

}  // namespace armtune::internal::yaml
