#include "sim/controller_files/commanded_interfaces.hpp"

namespace armtune::internal {

std::vector<std::string> commanded_interfaces(const RosController& controller) {
  std::vector<std::string> interfaces;
  if (controller.ros2) {
    const yaml::PlacedValue* given = controller.parameters->find("command_interfaces");
    if (given == nullptr) return interfaces;
    for (const yaml::PlacedEntry& item : given->items) interfaces.push_back(item.value->text);
  } else if (controller.type.find('/') != std::string::npos) {
    interfaces.push_back(controller.type.starts_with("effort_")     ? "effort"
                         : controller.type.starts_with("velocity_") ? "velocity"
                                                                    : controller.type);
  }
  return interfaces;
}

bool are_simulated(const std::vector<std::string>& interfaces, bool ros2) {
  if (interfaces.empty()) return !ros2;
  return interfaces.size() == 1 && (interfaces.front() == "effort" || interfaces.front() == "velocity");
}

}  // namespace armtune::internal
