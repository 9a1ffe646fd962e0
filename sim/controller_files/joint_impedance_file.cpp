#include "sim/controller_files/joint_impedance_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_impedance_law.hpp"
#include "sim/controller_files/parameter_reader.hpp"

namespace armtune::internal {
namespace {

using yaml::PlacedValue;

constexpr double kFilter = 0.01;        // share of the last filtered velocity in the next, for all types
constexpr double kTorqueRate = 1000.0;  // N m/s: 1 N m in each period of 1 ms
constexpr const char* kCoriolisFactor = "coriolis_factor";
constexpr const char* kExample = "JointImpedanceExampleController";
constexpr const char* kWithIk = "JointImpedanceWithIKExampleController";

/// The keys of the two lists, with armtune's names of the gains in them.
constexpr std::pair<const char*, const char*> kLists[] = {{"k_gains", "joint_impedance_k"},
                                                          {"d_gains", "joint_impedance_d"}};

/// The parts of the control law besides spring and damper. They depend on the controller's type.
struct Options {
  double velocity_factor = 0.0;
  double coriolis_factor = 0.0;
  double torque_rate = 0.0;
};

std::string class_of(const RosController& controller) {
  return controller.type.substr(controller.type.find_last_of('/') + 1);
}

/// Returns the options of the controller's type. Throws InputError for an unknown type.
Options options_of(const ParameterReader& reader) {
  const RosController& controller = reader.controller();
  if (is_known_joint_impedance(controller)) {
    if (class_of(controller) == kWithIk) return {0.0, 1.0, 0.0};
    if (controller.ros2) return {};
    const PlacedValue* factor = controller.parameters->find(kCoriolisFactor);
    return {1.0, factor == nullptr ? 1.0 : reader.finite(*factor, kCoriolisFactor), kTorqueRate};
  }
  const std::string what =
      controller.type.empty()
          ? "the file does not give the type of this controller"
          : fmt::format("armtune does not know what {} does with k_gains and d_gains", controller.type);
  reader.fail(controller.parameters->line,
              what +
                  "; the types that armtune simulates are franka_example_controllers/"
                  "JointImpedanceExampleController and, in ROS 2, JointImpedanceWithIKExampleController",
              controller.type, "JointImpedanceExampleController or JointImpedanceWithIKExampleController");
}

/// Throws InputError if the file has joint names that are not the arm's, in its order. Lists without names
/// are in the arm's order. Names that contain $(arg ...) are not known, and not checked.
void require_joints(const ParameterReader& reader, const std::vector<std::string>& joints) {
  const PlacedValue* names = reader.controller().parameters->find("joint_names");
  if (names == nullptr) return;
  std::vector<std::string> found;
  for (const yaml::PlacedEntry& item : names->items) found.push_back(item.value->text);
  const bool open = std::any_of(found.begin(), found.end(),
                                [](const std::string& name) { return name.find("$(") != std::string::npos; });
  if (!open && found != joints)
    reader.fail(names->line,
                fmt::format("joint_names are {}, but the arm's joints are {}, in this order",
                            fmt::join(found, ", "), fmt::join(joints, ", ")),
                fmt::format("{}", fmt::join(found, ", ")), fmt::format("{}", fmt::join(joints, ", ")));
}

}  // namespace

bool is_known_joint_impedance(const RosController& controller) {
  const std::string name = class_of(controller);
  return name == kExample || (controller.ros2 && name == kWithIk);
}

Gains joint_impedance_gains(const RosController& controller, const std::string& file,
                            const std::vector<std::string>& joints) {
  const ParameterReader reader(controller, file);
  const Options options = options_of(reader);
  require_joints(reader, joints);
  const auto n = static_cast<Eigen::Index>(joints.size());
  Gains gains;
  change_controller(gains, kJointImpedance, static_cast<int>(n));
  gains.joint_space_gains_p = gains.joint_space_gains_d = JointVector::Zero(n);
  gains.force_control_gains = JointVector::Zero(n);
  for (const auto& [key, gain] : kLists) {
    const PlacedValue& list = *controller.parameters->find(key);
    if (list.items.size() != joints.size())
      reader.fail(
          list.line,
          fmt::format("{} has {} numbers, but the arm has {} joints", key, list.items.size(), joints.size()),
          fmt::to_string(list.items.size()), fmt::to_string(joints.size()));
    for (std::size_t k = 0; k < joints.size(); ++k)
      own(gains, gain)[static_cast<Eigen::Index>(k)] =
          reader.finite(*list.items[k].value, fmt::format("{}[{}]", key, k));
  }
  own(gains, "joint_impedance_velocity_factor")[0] = options.velocity_factor;
  own(gains, "joint_impedance_coriolis_factor")[0] = options.coriolis_factor;
  own(gains, "joint_impedance_filter")[0] = kFilter;
  own(gains, "joint_impedance_torque_rate")[0] = options.torque_rate;
  return gains;
}

std::vector<PlacedGain> placed_impedance_gains(const RosController& controller, const Gains& gains,
                                               const std::vector<std::string>& joints) {
  std::vector<PlacedGain> placed;
  for (const auto& [key, gain] : kLists) {
    const PlacedValue& list = *controller.parameters->find(key);
    for (std::size_t k = 0; k < joints.size(); ++k)
      placed.push_back({list.items[k].value.get(),
                        {key, joints[k]},
                        own(gains, gain)[static_cast<Eigen::Index>(k)],
                        fmt::format("{}/{}", gain, joints[k])});
  }
  if (!controller.ros2)
    placed.push_back({controller.parameters->find(kCoriolisFactor),
                      {kCoriolisFactor, ""},
                      own(gains, "joint_impedance_coriolis_factor")[0],
                      "joint_impedance_coriolis_factor"});
  return placed;
}

}  // namespace armtune::internal
