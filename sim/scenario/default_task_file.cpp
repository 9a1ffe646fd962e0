#include "sim/scenario/default_task_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

std::string list(const Vec3& x) {
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", x.x(), x.y(), x.z());
}

}  // namespace

std::string default_task_yaml(const DefaultTask& task, const std::string& robot) {
  const Scenario& s = task.scenario;
  const std::string description =
      fmt::format("a circle that {} follows far from singular positions and joint limits{}", s.robot->name,
                  tracks_orientation(s.mask) ? ", with the gaze switching between two targets" : "");
  std::string text = fmt::format(
      "description: {0}\nrobot: {1}\nduration: {2}            "
      "# s\ncontrol_period: {3}   # s\nstart_position_deg: [{4:.4g}]\n"
      "task_mask: {5}   # what the arm tracks: pose, position_and_axis or position\n\n"
      "# center + sum of cos and sin terms of order k at k * frequency, base frame\npath:\n  center: {6}   # "
      "m\n"
      "  frequency: {7}   # rad/s\n  terms:\n    - {{order: 1, cos: {8}, sin: {9}}}\n\nswitch_every: {10}   "
      "# s\ntargets:\n",
      yaml::quoted(description), yaml::quoted(robot), s.duration, s.control_period,
      fmt::join(in_degrees(*s.robot, s.start_position), ", "), name(s.mask), list(s.path.center),
      s.path.frequency, list(s.path.terms[0].cosine), list(s.path.terms[0].sine), s.switch_every);
  for (const NamedPath& target : s.targets)
    text += fmt::format("  - {{name: {}, center: {}}}\n", target.name, list(target.path.center));
  if (s.clearance && !task.in_given_cell) {
    text += s.clearance->cell().floor
                ? fmt::format("cell: {{floor: {}}}   # m; the arm must touch neither the floor nor itself\n",
                              *s.clearance->cell().floor)
                : "cell: {}   # the arm must not touch itself\n";
  }
  if (task.without_floor)
    text += "# There is no floor: no first task was found above the height of the arm's base.\n";
  text += fmt::format(
      "\n# Properties of the real arm that the controller's model lacks.\ntheta_start: {{model_scale: "
      "{}}}\nplant:\n"
      "  position_noise: {}      # rad, m\n  velocity_noise: {}      # rad/s, m/s\n  torque_delay_periods: "
      "{}\n"
      "  payload: {{mass: {:.4g}, center: [0, 0, 0]}}   # kg, at the tool\nseed: 1\n",
      s.theta.model_scale, s.plant.position_noise, s.plant.velocity_noise, s.plant.torque_delay_periods,
      s.plant.payload.mass);
  return text;
}

}  // namespace armtune::internal
