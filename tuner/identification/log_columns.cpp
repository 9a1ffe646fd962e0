#include "tuner/identification/log_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/yaml/file_units.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

/// Returns one value per joint, from a list in joint order or from a map by joint name.
std::vector<const yaml::Node*> by_joint(const yaml::Node& node, const std::vector<std::string>& joints) {
  std::vector<const yaml::Node*> values;
  values.reserve(joints.size());
  if (node.kind() == yaml::Node::Kind::kSequence) {
    for (const yaml::Node& item : node.items()) values.push_back(&item);
    if (values.size() != joints.size()) {
      node.fail(InputFault{.problem = fmt::format("has {} entries, but the arm has {} joints: {}",
                                                  values.size(), joints.size(), fmt::join(joints, " ")),
                           .value = std::to_string(values.size()),
                           .limit = fmt::format("{} entries", joints.size())});
    }
    return values;
  }
  yaml::MapReader map(node);
  for (const std::string& joint : joints) values.push_back(&map.required(joint));
  map.finish();
  return values;
}

double checked_scale(const yaml::Node& node) {
  const double scale = node.as_number();
  if (scale == 0.0)
    node.fail("is 0; a scale is the factor that converts the numbers to SI units", "other than 0");
  return scale;
}

std::vector<double> read_scales(const yaml::Node* node, const std::vector<std::string>& joints) {
  if (node == nullptr) return std::vector<double>(joints.size(), 1.0);
  if (node->kind() == yaml::Node::Kind::kScalar)
    return std::vector<double>(joints.size(), checked_scale(*node));
  std::vector<double> scales;
  scales.reserve(joints.size());
  for (const yaml::Node* entry : by_joint(*node, joints)) scales.push_back(checked_scale(*entry));
  return scales;
}

std::vector<LogColumn> read_columns(const yaml::Node& node, const std::vector<std::string>& joints) {
  yaml::MapReader map(node);
  const std::vector<double> scales = read_scales(map.optional("scale"), joints);
  const auto names = by_joint(map.required("columns"), joints);
  map.finish();
  std::vector<LogColumn> columns;
  columns.reserve(joints.size());
  for (std::size_t i = 0; i < names.size(); ++i) columns.push_back({names[i]->as_string(), scales[i]});
  return columns;
}

/// Multiplies the scales by the units. Joints that turn use the units of angle and torque. Joints that slide
/// use the unit of length, and their forces are in N.
void use_units(const yaml::FileUnits& units, const RobotModel& model, LogColumns& columns) {
  columns.time.scale *= units.time;
  for (std::size_t i = 0; i < columns.position.size(); ++i) {
    const bool turns = model.chain.motion[i] == JointMotion::kRevolute;
    const double motion = turns ? units.angle : units.length;
    columns.position[i].scale *= motion;
    if (!columns.velocity.empty()) columns.velocity[i].scale *= motion;
    if (turns) columns.torque[i].scale *= units.torque;
  }
}

}  // namespace

LogColumns default_log_columns(const RobotModel& model) {
  LogColumns columns;
  columns.time.name = "time";
  columns.velocity_optional = true;
  for (const std::string& joint : joint_names(model)) {
    columns.position.push_back({"joint/" + joint + "/position"});
    columns.velocity.push_back({"joint/" + joint + "/velocity"});
    columns.torque.push_back({"joint/" + joint + "/torque"});
  }
  return columns;
}

LogColumns load_log_columns(const std::string& path, const RobotModel& model) {
  const yaml::Node root = yaml::parse_file(path);
  yaml::MapReader map(root);
  const auto joints = joint_names(model);
  LogColumns columns = default_log_columns(model);
  columns.time.name = map.string("time", columns.time.name);
  if (const yaml::Node* scale = map.optional("time_scale")) {
    columns.time.scale = checked_scale(*scale);
    if (columns.time.scale < 0.0) scale->fail("is negative; time stamps increase", "above zero");
  }
  const yaml::Node* position = map.optional("position");
  const yaml::Node* velocity = map.optional("velocity");
  if (position != nullptr) columns.position = read_columns(*position, joints);
  if (position != nullptr || velocity != nullptr) {
    columns.velocity_optional = false;
    columns.velocity = velocity == nullptr ? std::vector<LogColumn>() : read_columns(*velocity, joints);
  }
  if (const yaml::Node* torque = map.optional("torque")) columns.torque = read_columns(*torque, joints);
  if (const yaml::Node* units = map.optional("units"))
    use_units(yaml::read_file_units(*units, "time length angle torque"), model, columns);
  map.finish();
  return columns;
}

}  // namespace armtune::internal
