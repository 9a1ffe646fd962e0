#pragma once
// Collects the parameters that each node of ROS 2 receives from a parameter file. A node receives the
// parameters below its own name, and those below every wildcard that matches its name. A name with dots, such
// as `gains.elbow.p`, is the same parameter as p in nested maps.
//
// Source: parse.c of rcl_yaml_param_parser (rcl, commit 07a92fa) and parameter_map_from of rclcpp (commit
// 0f42d78), as in ROS 2 Humble and Jazzy. Node names are applied in the order in which the file first has
// them. A later value replaces an earlier one, even if the earlier node name is more specific.

#include <string>
#include <vector>

#include "sim/yaml/placed_value.hpp"

namespace armtune::internal {

/// A node whose parameters may be those of a controller.
struct RosNode {
  std::string name;  ///< as the file has it, namespaces included: "left/arm_controller", "/**/arm_controller"
  yaml::Placed parameters;  ///< a map; its scalars and lists are those of the file
};

/// Returns the nodes that have gains or command interfaces of their own, in the order of the file. "Own"
/// means below another name than `/**`. A wildcard, `/**` included, is a node if it has such parameters and
/// no other node receives them. Throws InputError if wildcards give more than kMaxItems parameters to nodes.
std::vector<RosNode> ros2_nodes(const yaml::PlacedValue& root, const std::string& file);

}  // namespace armtune::internal
