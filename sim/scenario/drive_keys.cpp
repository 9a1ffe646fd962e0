#include "sim/scenario/drive_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <limits>

#include "sim/yaml/joint_values.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLongestDelay = 0.1;             // s
constexpr double kSlowest = 1.0, kFastest = 1e5;  // Hz

/// A value of the drives with one number for each joint.
struct Key {
  const char* name;
  const char* unit;
  JointVector RobotModel::*values;
  bool may_be_zero;
  double most;
};
constexpr std::array kKeys = {
    Key{"velocity_gain", "N m s/rad, N s/m", &RobotModel::drive_velocity_gain, false, kInfinity},
    Key{"velocity_integral", "N m/rad, N/m", &RobotModel::drive_velocity_integral, true, kInfinity},
    Key{"position_gain", "1/s", &RobotModel::drive_position_gain, false, kInfinity},
    Key{"torque_rate", "N m/s, N/s", &RobotModel::drive_torque_rate, false, kInfinity},
    Key{"delay", "s", &RobotModel::drive_delay, true, kLongestDelay}};

JointVector read_values(const yaml::Node& node, const std::vector<std::string>& joints, const Key& key) {
  JointVector values;
  if (node.kind() == yaml::Node::Kind::kScalar) {
    values = JointVector::Constant(static_cast<Eigen::Index>(joints.size()), node.as_number());
  } else {
    values = yaml::joint_values(node, joints);
  }
  for (const double value : values) {
    if (std::isfinite(value) && (key.may_be_zero ? value >= 0.0 : value > 0.0) && value <= key.most) continue;
    const std::string most = std::isfinite(key.most) ? fmt::format(", and at most {}", key.most) : "";
    node.fail(InputFault{
        .problem = fmt::format("a value is {} {}", value, key.unit),
        .value = fmt::to_string(value),
        .limit = fmt::format("finite and {}{}", key.may_be_zero ? "at least 0" : "above 0", most)});
  }
  return values;
}

}  // namespace

void read_drives(const yaml::Node& node, const std::vector<std::string>& joints, RobotModel& model) {
  yaml::MapReader map(node);
  for (const Key& key : kKeys) {
    const yaml::Node* given = map.optional(key.name);
    if (given == nullptr) continue;
    JointVector& values = model.*key.values;
    if (values.size() > 0)
      given->fail(fmt::format("the file gives this twice; remove the key drive_{}", key.name));
    values = read_values(*given, joints, key);
  }
  if (map.has("rate")) model.drive_rate = map.number_in("rate", 0.0, kSlowest, kFastest);
  map.finish();
}

std::vector<DriveValue> drive_values(const RobotModel& model) {
  std::vector<DriveValue> found;
  for (const Key& key : kKeys) {
    if ((model.*key.values).size() > 0) found.push_back({key.name, key.unit, model.*key.values});
  }
  if (model.drive_rate > 0.0) found.push_back({"rate", "Hz", JointVector::Constant(1, model.drive_rate)});
  return found;
}

std::string drives_yaml(const RobotModel& model) {
  std::string text;
  for (const DriveValue& drive : drive_values(model)) {
    text += drive.key == "rate"
                ? fmt::format("  {}: {}  # {}\n", drive.key, drive.values[0], drive.unit)
                : fmt::format("  {}: [{}]  # {}\n", drive.key, fmt::join(drive.values, ", "), drive.unit);
  }
  return text.empty() ? text : "drives:\n" + text;
}

}  // namespace armtune::internal
