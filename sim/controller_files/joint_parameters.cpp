#include "sim/controller_files/joint_parameters.hpp"

#include <utility>

namespace armtune::internal {

using yaml::PlacedValue;

namespace {

/// Returns the value of a joint in a map, or null if there is none.
const PlacedValue* joint_in(const PlacedValue& map, const std::string& joint) {
  for (const yaml::PlacedEntry& entry : map.entries) {
    if (without_prefix(entry.key) == joint) return entry.value.get();
  }
  return nullptr;
}

}  // namespace

std::string without_prefix(const std::string& key) {
  for (const auto& [open, close] : {std::pair{"$(", ')'}, {"${", '}'}}) {
    const std::size_t end = key.find(close);
    if (key.starts_with(open) && end != std::string::npos) return without_prefix(key.substr(end + 1));
  }
  return key;
}

const PlacedValue* JointParameters::of_joint(const std::string& joint, const char* key) const {
  const PlacedValue* gains = controller().parameters->find("gains");
  const PlacedValue* own = joint_in(*gains, joint);
  return own == nullptr ? nullptr : own->find(key);
}

const PlacedValue* JointParameters::feed_forward(const std::string& joint) const {
  if (controller().ros2) return of_joint(joint, "ff_velocity_scale");
  const PlacedValue* map = controller().parameters->find("velocity_ff");
  return map == nullptr ? nullptr : joint_in(*map, joint);
}

}  // namespace armtune::internal
