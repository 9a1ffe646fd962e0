#include "sim/yaml/joint_values.hpp"

#include <algorithm>

#include "sim/yaml/map_reader.hpp"

namespace armtune::internal::yaml {

namespace {

bool are_of(const Node& node, const std::vector<std::string>& joints) {
  if (node.kind() == Node::Kind::kSequence) return node.items().size() == joints.size();
  if (node.kind() != Node::Kind::kMap) return true;
  const auto is_joint = [&joints](const auto& entry) {
    return std::find(joints.begin(), joints.end(), entry.first) != joints.end();
  };
  const auto& entries = node.entries();
  return entries.size() == joints.size() && std::all_of(entries.begin(), entries.end(), is_joint);
}

JointVector read_values(const Node& node, const std::vector<std::string>& joints) {
  if (node.kind() != Node::Kind::kMap) {
    const auto values = node.as_numbers(joints.size());
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  }
  MapReader map(node);
  JointVector values(static_cast<Eigen::Index>(joints.size()));
  Eigen::Index i = 0;
  for (const std::string& joint : joints) values[i++] = map.number(joint);
  map.finish();
  return values;
}

}  // namespace

JointVector joint_values(const Node& node, const std::vector<std::string>& joints) {
  try {
    return read_values(node, joints);
  } catch (const InputError& error) {
    if (are_of(node, joints)) throw;
    throw OtherJoints(error);
  }
}

}  // namespace armtune::internal::yaml
