// armtune robot: what was loaded.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "sim/scenario/robot_file.hpp"
#include "tuner/cli/commands.hpp"

namespace armtune::cli {
namespace {

void show(const RobotModel& model) {
  double mass = 0.0;
  for (int i = 0; i < model.n(); ++i) mass += model.chain.link[static_cast<std::size_t>(i)].mass;
  fmt::print("{} from {}\n{} joints, base {}, tool frame on {}, moving mass {:.4g} kg, reach {:.4g} m\n\n",
             model.name, model.source, model.n(), model.base_link, model.tip_link, mass, reach(model));
  fmt::print("{:<24}{:<10}{:>10}{:>10}{:>11}{:>9}{:>9}{:>9}{:>9}  {}\n", "joint", "type", "lower", "upper",
             "velocity", "effort", "rotor", "viscous", "coulomb", "link, mass [kg]");
  for (int i = 0; i < model.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const JointInfo& joint = model.joints[k];
    const auto bound = [&](double v) { return joint.limits.has_position ? fmt::format("{:.4g}", v) : "-"; };
    fmt::print("{:<24}{:<10}{:>10}{:>10}{:>11.4g}{:>9.4g}{:>9.3g}{:>9.3g}{:>9.3g}  {}, {:.4g}\n", joint.name,
               model.chain.motion[k] == JointMotion::kPrismatic
                   ? "prismatic"
                   : (joint.limits.has_position ? "revolute" : "continuous"),
               bound(joint.limits.lower), bound(joint.limits.upper), joint.limits.velocity,
               joint.limits.effort, model.chain.rotor_inertia[i], model.chain.viscous_friction[i],
               model.chain.coulomb_friction[i], joint.link, model.chain.link[k].mass);
  }
  fmt::print("\nSI units: rad, m, rad/s, m/s, N m, N, kg m^2.\n");
  if (model.chain.rotor_inertia.isZero(0.0)) {
    fmt::print(
        "No rotor inertia is given. Geared joints have some, and light wrists cannot be simulated under "
        "useful gains without it:\nwrite a robot YAML with 'urdf:' and 'rotor_inertia:'.\n");
  }
}

}  // namespace

void add_robot_command(CLI::App& app, int&) {
  auto file = std::make_shared<std::string>("ur10");
  CLI::App* command =
      app.add_subcommand("robot", "Show what a robot file holds: joints, limits, masses, reach");
  command->add_option("ROBOT", *file, "a bundled robot, a robot YAML, or an expanded URDF")
      ->capture_default_str();
  command->callback([file] { show(*load_robot(*file)); });
}

}  // namespace armtune::cli
