#include "core/robot/urdf_interfaces.hpp"

#include <algorithm>
#include <pugixml.hpp>

namespace armtune::internal {
namespace {

void add_names(const pugi::xml_node& joint, const char* element, std::vector<std::string>& names) {
  for (const pugi::xml_node& interface : joint.children(element)) {
    const std::string name = interface.attribute("name").value();
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
}

}  // namespace

std::map<std::string, JointInterfaces> ros2_control_interfaces(const std::string& urdf) {
  std::map<std::string, JointInterfaces> found;
  pugi::xml_document document;
  if (!document.load_buffer(urdf.data(), urdf.size())) return found;
  for (const pugi::xml_node& control : document.child("robot").children("ros2_control")) {
    for (const pugi::xml_node& joint : control.children("joint")) {
      JointInterfaces& interfaces = found[joint.attribute("name").value()];
      add_names(joint, "command_interface", interfaces.command);
      add_names(joint, "state_interface", interfaces.state);
    }
  }
  return found;
}

}  // namespace armtune::internal
