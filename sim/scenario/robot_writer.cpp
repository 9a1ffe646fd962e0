#include "sim/scenario/robot_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/drive_keys.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

/// Returns the mark of the rotor inertia in a robot YAML; empty if it has none.
std::string rotor_mark(const RobotModel& model) {
  if (!model.estimated_rotors.empty()) return "estimated";
  return model.rotor_source == RotorSource::kGiven ? "" : name(model.rotor_source);
}

}  // namespace

std::string robot_yaml(const RobotModel& model, const std::string& urdf, const std::string& comment) {
  const Chain& chain = model.chain;
  const auto list = [](const JointVector& values) { return fmt::format("[{}]", fmt::join(values, ", ")); };
  const std::string mark = rotor_mark(model);
  const std::string rotors = list(chain.rotor_inertia);
  return (comment.empty() ? "" : "# " + comment + "\n") +
         fmt::format(
             "urdf: {}\nbase_link: {}\ntip_link: {}\nrotor_inertia: {}  # kg m^2, kg\n"
             "viscous_friction: {}  # N m s/rad, N s/m\ncoulomb_friction: {}  # N m, N\n{}",
             yaml::quoted(urdf), yaml::quoted(model.base_link), yaml::quoted(urdf_tool_link(model)),
             mark.empty() ? rotors : fmt::format("{{{}: {}}}", mark, rotors), list(chain.viscous_friction),
             list(chain.coulomb_friction), model.compensates_gravity ? "compensates_gravity: true\n" : "") +
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
