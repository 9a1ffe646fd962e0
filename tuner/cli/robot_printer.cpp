#include "tuner/cli/robot_printer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/robot/rotor_estimate.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/plausibility.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/cli/robot_contacts.hpp"
#include "tuner/cli/robot_notes.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/session_printer.hpp"

namespace armtune::internal::cli {
namespace {

/// Prints two tables, each at most 80 columns wide: the limits of the joints, and their rotor inertia,
/// friction and links.
void show_joints(const RobotModel& model) {
  std::size_t width = 5;
  for (const JointInfo& joint : model.joints) width = std::max(width, joint.name.size());
  say(fmt::format("{:<{}}  {:<11}{:>10}{:>10}{:>10}{:>9}\n", "joint", width, "type", "lower", "upper",
                  "velocity", "effort"));
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const JointLimits& limits = model.joints[k].limits;
    const auto bound = [&limits](double v) { return limits.has_position ? fmt::format("{:.4g}", v) : "-"; };
    const char* type = model.chain.motion[k] == JointMotion::kPrismatic ? "prismatic"
                       : limits.has_position                            ? "revolute"
                                                                        : "continuous";
    say(fmt::format("{:<{}}  {:<11}{:>10}{:>10}{:>10.4g}{:>9.4g}\n", model.joints[k].name, width, type,
                    bound(limits.lower), bound(limits.upper), limits.velocity, limits.effort));
  }
  say(fmt::format("\n{:<{}}  {:>8} {:>9}{:>9}  {}\n", "joint", width, "rotor", "viscous", "coulomb",
                  "link, mass [kg]"));
  for (int i = 0; i < model.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const JointInfo& joint = model.joints[k];
    say(fmt::format("{:<{}}  {:>8.3g}{}{:>9.3g}{:>9.3g}  {}, {:.4g}\n", joint.name, width,
                    model.chain.rotor_inertia[i], has_estimated_rotor(model, i) ? "*" : " ",
                    model.chain.viscous_friction[i], model.chain.coulomb_friction[i], joint.link,
                    model.chain.link[k].mass));
  }
}

}  // namespace

void show_robot(const RobotModel& model) {
  double mass = 0.0;
  for (int i = 0; i < model.n(); ++i) mass += model.chain.link[static_cast<std::size_t>(i)].mass;
  say(fmt::format(
      "{} from {}\n{} joints, base {}, tool frame on {}, moving mass {:.4g} kg, reach {:.4g} m\n\n",
      model.name, model.source, model.n(), model.base_link, model.tip_link, mass, reach(model)));
  show_joints(model);
  say(fmt::format("\nSI units: rad, m, rad/s, m/s, N m, N, kg m^2.\n"));
  show_robot_notes(model);
  show_contacts(model);
  for (const std::string& doubt : doubts(model)) print_warning(doubt);
}

void list_bundled_robots() {
  const auto show = [](const auto&... cells) {
    say(fmt::format("{:<10}{:>7}{:>12}  {:<14} {}\n", cells...));
  };
  show("robot", "joints", "reach [m]", "rotor inertia", "friction");
  for (const std::string& name : bundled_names("robots")) {
    const auto robot = load_robot(name);
    const bool rubs =
        !robot->chain.viscous_friction.isZero(0.0) || !robot->chain.coulomb_friction.isZero(0.0);
    show(name, robot->n(), fmt::format("{:.3g}", reach(*robot)),
         robot->estimated_rotors.empty() ? internal::name(robot->rotor_source) : "estimated",
         rubs ? internal::name(robot->viscous_source) : "unknown, zero");
  }
  say("\n'armtune robot NAME' shows one of them, 'armtune robot FILE.urdf' an arm of your own.\n");
}

}  // namespace armtune::internal::cli
