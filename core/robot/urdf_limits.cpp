#include "core/robot/urdf_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "armtune/error.hpp"

namespace armtune::internal {

JointLimits limits_of(const UrdfJoint& joint, const UrdfOptions& options, const std::string& source,
                      MissingData* missing) {
  const auto found = options.limits.find(joint.name);
  const GivenLimits none;
  const GivenLimits& given = found == options.limits.end() ? none : found->second;
  const bool turns_freely = joint.motion == UrdfMotion::kContinuous && !given.lower && !given.upper;
  const auto range = position_range(joint, options);
  const bool lacks_position = !range && !turns_freely;
  if (missing == nullptr && lacks_position)
    throw InputError(
        InputPlace{source, 0, joint.name + "/lower"},
        fmt::format(
            "joint '{}': its lower and upper position limits are missing or the same; give both in the URDF "
            "or by 'limits' in a robot YAML",
            joint.name))
        .with_value({}, "a lower limit below an upper one");
  const UrdfJoint::Limits file = joint.limits.value_or(UrdfJoint::Limits{});
  const auto [lower, upper] = range.value_or(std::pair(0.0, 0.0));
  JointLimits limits{range.has_value(),
                     lower,
                     upper,
                     given.velocity.value_or(file.velocity),
                     given.effort.value_or(file.effort),
                     file.soft && !(given.lower && given.upper),
                     given.acceleration.value_or(std::numeric_limits<double>::infinity())};
  if (missing != nullptr) {
    if (lacks_position) {
      missing->position.push_back(joint.name);
      limits.has_position = true;
      limits.lower = -1.0;
      limits.upper = 1.0;
    }
    // A limit of 0 counts as missing. A negative limit is kept, and refused later.
    if (limits.velocity == 0.0) missing->velocity.push_back(joint.name);
    if (limits.effort == 0.0) missing->effort.push_back(joint.name);
    if (limits.velocity == 0.0) limits.velocity = 1.0;
    if (limits.effort == 0.0) limits.effort = 1.0;
  }
  return limits;
}

double place_to_hold(const UrdfJoint& joint, const UrdfOptions& options) {
  const auto range = position_range(joint, options);
  return range ? std::max(range->first, std::min(range->second, 0.0)) : 0.0;
}

}  // namespace armtune::internal
