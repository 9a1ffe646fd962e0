#include "sim/controller_files/joint_parameters.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"

namespace armtune::internal {

using yaml::PlacedValue;

void JointParameters::fail(int line, const std::string& what) const {
  throw InputError(one_line(fmt::format("{}:{}: {}: {}", file_, line, controller_.name, what)));
}

const PlacedValue* JointParameters::of_joint(const std::string& joint, const char* key) const {
  const PlacedValue* gains = controller_.parameters->find("gains");
  const PlacedValue* own = gains->find(joint);
  return own == nullptr ? nullptr : own->find(key);
}

const PlacedValue* JointParameters::feed_forward(const std::string& joint) const {
  if (controller_.ros2) return of_joint(joint, "ff_velocity_scale");
  const PlacedValue* map = controller_.parameters->find("velocity_ff");
  return map == nullptr ? nullptr : map->find(joint);
}

}  // namespace armtune::internal
