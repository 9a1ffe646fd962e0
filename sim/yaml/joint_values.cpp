#include "sim/yaml/joint_values.hpp"

#include "sim/yaml/map_reader.hpp"

namespace armtune::yaml {

JointVector joint_values(const Node& node, const std::vector<std::string>& joints) {
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

}  // namespace armtune::yaml
