#include "sim/yaml/force_gains.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/yaml/joint_values.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal::yaml {
namespace {

bool is_number(const Node* node) {
  return node->kind() != Node::Kind::kSequence && node->kind() != Node::Kind::kMap;
}

/// Returns the value of each force point (force_gains.hpp), in joint order if the points have names.
std::vector<const Node*> values_of(const Node& node, const std::vector<std::string>& joints) {
  std::vector<const Node*> values;
  if (node.kind() != Node::Kind::kMap) {
    for (const Node& item : node.items()) values.push_back(&item);
    return values;
  }
  MapReader map(node);
  for (const std::string& joint : joints) values.push_back(&map.required(joint));
  map.finish();
  return values;
}

}  // namespace

ForceGains force_gains(const Node& node, const std::vector<std::string>& joints) {
  if (node.kind() != Node::Kind::kSequence && node.kind() != Node::Kind::kMap)
    return joint_values(node, joints);
  const std::vector<const Node*> points = values_of(node, joints);
  const std::size_t n = joints.size();
  const auto numbers = std::count_if(points.begin(), points.end(), is_number);
  if (numbers == static_cast<std::ptrdiff_t>(points.size())) {
    if (points.size() != n * n) return joint_values(node, joints);
    const auto values = node.as_numbers(n * n);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  }
  if (points.size() != n) {
    node.fail(InputFault{.problem = fmt::format("the list has {} entries", points.size()),
                         .value = std::to_string(points.size()),
                         .limit = fmt::format("{} lists (one for each joint), or {} numbers", n, n)});
  }
  ForceGains gains(static_cast<Eigen::Index>(n * n));
  Eigen::Index row = 0;
  for (const Node* point : points) {
    if (is_number(point)) {
      point->fail(fmt::format(
          "this is a number among lists; give one number for every joint, or one list of {} numbers for "
          "every joint",
          n));
    }
    gains.segment(row, static_cast<Eigen::Index>(n)) = joint_values(*point, joints);
    row += static_cast<Eigen::Index>(n);
  }
  return gains;
}

}  // namespace armtune::internal::yaml
