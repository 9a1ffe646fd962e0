#include "tuner/cli/robot_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/robot/rotor_estimate.hpp"
#include "sim/cell/clearance_model.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/plausibility.hpp"
#include "sim/scenario/robot_file.hpp"
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

/// Prints which rotor inertias are estimated, and an estimate if the file does not give all of them.
void show_rotors(const RobotModel& model) {
  if (!model.estimated_rotors.empty())
    say("* an estimate, from the robot file or computed from the effort and velocity limits\n");
  std::vector<std::string> lacking;
  for (int i = 0; i < model.n(); ++i) {
    if (model.chain.rotor_inertia[i] == 0.0)
      lacking.push_back(model.joints[static_cast<std::size_t>(i)].name);
  }
  if (lacking.empty()) return;
  RobotModel estimated = model;
  estimate_rotors(estimated);
  std::vector<std::string> figures;
  figures.reserve(static_cast<std::size_t>(model.n()));
  for (int i = 0; i < model.n(); ++i)
    figures.push_back(fmt::format("{:.3g}", estimated.chain.rotor_inertia[i]));
  say(fmt::format(
      "\nNo rotor inertia is given for {}. Geared joints have rotor inertia. Without it, light\n"
      "wrists are unstable in simulation at gains that the real arm tolerates. Give it in a\n"
      "robot YAML with 'rotor_inertia: [...]', or write 'rotor_inertia: estimated' for this\n"
      "estimate from the effort and velocity limits: [{}].\n"
      "The option --task uses the estimate.\n",
      lacking.size() == std::size_t(model.n()) ? "the joints" : fmt::format("{}", fmt::join(lacking, ", ")),
      fmt::join(figures, ", ")));
}

void show_soft_limits(const RobotModel& model) {
  std::vector<std::string> soft;
  for (const JointInfo& joint : model.joints) {
    if (joint.limits.soft) soft.push_back(joint.name);
  }
  if (!soft.empty())
    say(fmt::format("The position limits of {} are the soft limits of the URDF's safety controllers.\n",
                    fmt::join(soft, ", ")));
}

void show_acceleration_limits(const RobotModel& model) {
  std::vector<std::string> given;
  for (const JointInfo& joint : model.joints) {
    if (std::isfinite(joint.limits.acceleration))
      given.push_back(fmt::format("{} {:.4g}", joint.name, joint.limits.acceleration));
  }
  if (!given.empty())
    say(fmt::format("Acceleration limits of the robot file [rad/s^2, m/s^2]: {}.\n", fmt::join(given, ", ")));
}

void add_new(const std::vector<std::string>& names, std::vector<std::string>& all) {
  for (const std::string& name : names) {
    if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
  }
}

/// Prints the ros2_control interfaces if the URDF gives any, and which joints cannot be commanded by effort.
void show_interfaces(const RobotModel& model) {
  std::vector<std::string> command, state, without_effort;
  for (const JointInfo& joint : model.joints) {
    const std::vector<std::string>& own = joint.interfaces.command;
    add_new(own, command);
    add_new(joint.interfaces.state, state);
    if (std::find(own.begin(), own.end(), "effort") == own.end()) without_effort.push_back(joint.name);
  }
  if (command.empty() && state.empty()) return;
  say(fmt::format("ros2_control: command interfaces {}; state interfaces {}.\n",
                  command.empty() ? "none" : fmt::format("{}", fmt::join(command, ", ")),
                  state.empty() ? "none" : fmt::format("{}", fmt::join(state, ", "))));
  if (!without_effort.empty())
    say(fmt::format(
        "The URDF gives {} no command interface for effort. All controllers of armtune command\n"
        "effort, except joint_trajectory_controller_velocity, which commands velocity.\n",
        without_effort.size() == model.joints.size() ? "these joints"
                                                     : fmt::format("{}", fmt::join(without_effort, ", "))));
}

/// Warns of collision shapes that are far larger than the arm's reach. The usual cause is a mesh in
/// millimetres, which is read as one in metres.
void warn_of_huge_shapes(const RobotModel& model, const ArmSolids& arm) {
  constexpr double kHuge = 10.0;  // as a multiple of the reach
  std::set<std::string> named;
  for (const ArmSolid& solid : arm.solids) {
    const double size = farthest(solid.placed, solid.placed.p_BS);
    if (size <= kHuge * reach(model) || !named.insert(solid.link).second) continue;
    print_warning(fmt::format(
        "{}: a collision shape extends {:.3g} m, but the reach of the whole arm is {:.3g} m; if the shape is "
        "a mesh in millimetres, add scale=\"0.001 0.001 0.001\" in the URDF",
        solid.link, size, reach(model)));
  }
}

/// Prints between which links self-collision is checked.
void show_contacts(const RobotModel& model) {
  const ClearanceModel contacts(std::make_shared<const RobotModel>(model), Cell{});
  std::vector<std::string> unknown = contacts.arm().unknown;
  if (!unknown.empty())
    say(fmt::format("Self-collision is not checked for {}, because shapes are missing or cannot be read.\n",
                    fmt::join(unknown, ", ")));
  warn_of_huge_shapes(model, contacts.arm());
  constexpr std::size_t kMostShown = 3;
  const std::vector<std::string>& unread = contacts.arm().unread;
  for (std::size_t i = 0; i < std::min(kMostShown, unread.size()); ++i) say(fmt::format("  {}\n", unread[i]));
  if (unread.size() > kMostShown) say(fmt::format("  and {} more shapes\n", unread.size() - kMostShown));
  if (contacts.has(Clearance::kSelf))
    say(fmt::format(
        "Self-collision is checked for {} pairs of shapes, between links that are not neighbours.\n",
        contacts.pairs().size()));
  const std::vector<std::string> left_out = contacts.left_out_by_their_make();
  if (!left_out.empty())
    say(
        fmt::format("Self-collision is not checked between links whose shapes touch at nearly every "
                    "position: {}.\n",
                    fmt::join(left_out, "; ")));
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
  show_soft_limits(model);
  show_acceleration_limits(model);
  show_interfaces(model);
  show_rotors(model);
  show_contacts(model);
  for (const std::string& doubt : doubts(model)) print_warning(doubt);
}

void list_bundled_robots() {
  say(fmt::format("{:<10}{:>7}{:>12}  {}\n", "robot", "joints", "reach [m]", "rotor inertia"));
  for (const std::string& name : bundled_names("robots")) {
    const auto robot = load_robot(name);
    say(fmt::format("{:<10}{:>7}{:>12.3g}  {}\n", name, robot->n(), reach(*robot),
                    robot->estimated_rotors.empty() ? "given" : "estimated"));
  }
  say("\n'armtune robot NAME' shows one of them, 'armtune robot FILE.urdf' an arm of your own.\n");
}

}  // namespace armtune::internal::cli
