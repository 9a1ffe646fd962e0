#include "sim/controller_files/joint_parameters.hpp"

namespace armtune::internal {

using yaml::PlacedValue;

const PlacedValue* JointParameters::of_joint(const std::string& joint, const char* key) const {
  const PlacedValue* gains = controller().parameters->find("gains");
  const PlacedValue* own = gains->find(joint);
  return own == nullptr ? nullptr : own->find(key);
}

const PlacedValue* JointParameters::feed_forward(const std::string& joint) const {
  if (controller().ros2) return of_joint(joint, "ff_velocity_scale");
  const PlacedValue* map = controller().parameters->find("velocity_ff");
  return map == nullptr ? nullptr : map->find(joint);
}

}  // namespace armtune::internal
