#include "tuner/cli/robot_notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/robot/rotor_estimate.hpp"
#include "sim/scenario/drive_keys.hpp"
#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {
namespace {

/// Prints the mark in the robot file of some of its values.
void show_mark(const char* what, ValueSource source) {
  if (source == ValueSource::kGiven) return;
  say(fmt::format("{}: {}, according to the robot file.{}\n", what, name(source),
                  source == ValueSource::kAssumed
                      ? " Nobody measured it, so every verdict lists it as an assumption."
                      : ""));
}

/// Prints the mark of the rotor inertia, and an estimate if the file does not give all of it.
void show_rotors(const RobotModel& model) {
  if (!model.estimated_rotors.empty())
    say("* an estimate, from the robot file or computed from the effort and velocity limits\n");
  show_mark("Rotor inertia", model.rotor_source);
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

/// Prints the marks of the friction, and which joints have none, because no file gives any.
void show_friction(const RobotModel& model) {
  show_mark("Viscous friction", model.viscous_source);
  show_mark("Coulomb friction", model.coulomb_source);
  std::vector<std::string> lacking;
  for (int i = 0; i < model.n(); ++i) {
    if (model.chain.viscous_friction[i] == 0.0 && model.chain.coulomb_friction[i] == 0.0)
      lacking.push_back(model.joints[static_cast<std::size_t>(i)].name);
  }
  if (lacking.empty()) return;
  const bool all = lacking.size() == static_cast<std::size_t>(model.n());
  say(fmt::format(
      "Joint friction: none given{}. It is unknown, and zero in simulation unless a scenario gives it.\n",
      all ? "" : fmt::format(" for {}", fmt::join(lacking, ", "))));
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

/// Prints the values of the drives that the robot file gives.
void show_drives(const RobotModel& model) {
  for (const DriveValue& drive : drive_values(model)) {
    const bool same = (drive.values.array() == drive.values[0]).all();
    say(fmt::format("Drives of the robot file, {} [{}]: {}.\n", drive.key, drive.unit,
                    same ? fmt::format("{:.4g}", drive.values[0])
                         : fmt::format("{:.4g}", fmt::join(drive.values, ", "))));
  }
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
        "effort, except joint_trajectory_controller_velocity, which commands velocity, and\n"
        "position_streaming, which commands position.\n",
        without_effort.size() == model.joints.size() ? "these joints"
                                                     : fmt::format("{}", fmt::join(without_effort, ", "))));
}

}  // namespace

void show_robot_notes(const RobotModel& model) {
  show_soft_limits(model);
  show_acceleration_limits(model);
  show_drives(model);
  show_interfaces(model);
  show_rotors(model);
  show_friction(model);
}

}  // namespace armtune::internal::cli
