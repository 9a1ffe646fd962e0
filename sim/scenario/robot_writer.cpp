#include "sim/scenario/robot_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/drive_keys.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

/// Returns a list of numbers, with the mark that says where they come from.
std::string marked_list(const JointVector& values, ValueSource source) {
  const std::string list = fmt::format("[{}]", fmt::join(values, ", "));
  return source == ValueSource::kGiven ? list : fmt::format("{{{}: {}}}", name(source), list);
}

}  // namespace

std::string robot_yaml(const RobotModel& model, const std::string& urdf, const std::string& comment) {
  const Chain& chain = model.chain;
  const ValueSource rotors = model.estimated_rotors.empty() ? model.rotor_source : ValueSource::kEstimated;
  return (comment.empty() ? "" : "# " + comment + "\n") +
         fmt::format(
             "urdf: {}\nbase_link: {}\ntip_link: {}\nrotor_inertia: {}  # kg m^2, kg\n"
             "viscous_friction: {}  # N m s/rad, N s/m\ncoulomb_friction: {}  # N m, N\n{}",
             yaml::quoted(urdf), yaml::quoted(model.base_link), yaml::quoted(urdf_tool_link(model)),
             marked_list(chain.rotor_inertia, rotors),
             marked_list(chain.viscous_friction, model.viscous_source),
             marked_list(chain.coulomb_friction, model.coulomb_source),
             model.compensates_gravity ? "compensates_gravity: true\n" : "") +
         drives_yaml(model) + acceleration_limits_yaml(model);
}

std::string acceleration_limits_yaml(const RobotModel& model) {
  std::string text;
  for (const JointInfo& joint : model.joints) {
    if (!std::isfinite(joint.limits.acceleration)) continue;
    text += fmt::format("  {}: {{acceleration: {}}}\n", yaml::word(joint.name), joint.limits.acceleration);
  }
  return text.empty() ? text : "limits:  # rad/s^2, m/s^2\n" + text;
}

}  // namespace armtune::internal
