#pragma once
// Reads from YAML the gains of the virtual forces by which obstacles repel the arm. The forces act at points
// of the arm. There is one number per point, or one list of n numbers (one for each joint) per point.

#include "core/control/force_gains.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal::yaml {

/// Returns n numbers, or n x n numbers with one row per force point [N]. In the file, the force points are a
/// list in joint order or a map by joint name. The n numbers of a force point can be given in the same two
/// ways. n x n numbers may also be one flat list, because ROS 2 has no lists of lists. Throws InputError with
/// file, line and key if a joint is missing or unknown, a count is wrong, or numbers and lists are mixed.
ForceGains force_gains(const Node& node, const std::vector<std::string>& joints);

}  // namespace armtune::internal::yaml
