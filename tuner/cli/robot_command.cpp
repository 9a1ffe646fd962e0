// armtune robot: what was loaded.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <set>
#include <string>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "core/common/path_state.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "core/robot/urdf_reader.hpp"
#include "sim/cell/clearance_model.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/plausibility.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/urdf_keys.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/first_task/first_task.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal::cli {
namespace {

/// Two tables, each within 80 columns: what the joints may do, and what they move.
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

/// What is known of the rotors of an arm whose file does not give them.
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

void add_new(const std::vector<std::string>& names, std::vector<std::string>& all) {
  for (const std::string& name : names) {
    if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
  }
}

/// What ros2_control can command, where the URDF says so.
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

/// Warns of shapes that no arm of this reach can have: a mesh in millimetres is read as one in metres.
void warn_of_huge_shapes(const RobotModel& model, const ArmSolids& arm) {
  constexpr double kHuge = 10.0;  // of the reach
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

/// Which links self-collision is looked for between.
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

void show(const RobotModel& model) {
  double mass = 0.0;
  for (int i = 0; i < model.n(); ++i) mass += model.chain.link[static_cast<std::size_t>(i)].mass;
  say(fmt::format(
      "{} from {}\n{} joints, base {}, tool frame on {}, moving mass {:.4g} kg, reach {:.4g} m\n\n",
      model.name, model.source, model.n(), model.base_link, model.tip_link, mass, reach(model)));
  show_joints(model);
  say(fmt::format("\nSI units: rad, m, rad/s, m/s, N m, N, kg m^2.\n"));
  show_soft_limits(model);
  show_interfaces(model);
  show_rotors(model);
  show_contacts(model);
  for (const std::string& doubt : doubts(model)) print_warning(doubt);
}

void make_task(const std::string& robot, const TaskOptions& options, const std::string& folder) {
  refuse_used_folder(folder);
  ProgressLine line;
  const FirstTask found = find_first_task(robot, options, default_workers(),
                                          [&line](const std::string& text) { line.show(text); });
  line.clear();
  write_first_task(found, folder);
  if (found.task.without_floor)
    print_warning(
        "no first task was found above the height of the arm's base, so this task has no floor; if the arm "
        "stands on a floor, give the height of the floor with --floor");
  if (!found.task.scenario.clearance)
    print_warning(
        "no shapes of the arm's links are known, so collisions of the arm with itself and its surroundings "
        "are not checked. If the task has a floor, it was used only to place the circle. To check "
        "collisions, give the folder of the meshes in ARMTUNE_MESHES, or 'shapes' in a robot YAML");
  say(fmt::format(
      "\nwrote {0}: {1}task.yaml (a circle with a radius of {2:.3g} m), gains.yaml, study.yaml\n"
      "With these gains the arm completes the task in Simbody, with at most {3:.2g} of its velocity limits\n"
      "and {4:.2g} of its effort limits{5}.\n"
      "In armtune's own dynamics the arm keeps its limits for 30 minutes. Nearly all of 60 random arms\n"
      "keep their position and velocity limits in one run of the task, and their torques saturate in\n"
      "at most 1 % of the control periods.\n"
      "next: armtune tune {0}/study.yaml\n",
      folder, found.robot_yaml.empty() ? "" : "robot.yaml (rotor inertia estimated), ",
      found.task.scenario.path.terms[0].cosine.norm(), found.metrics[Metric::kJointVelocityMaxRatio],
      found.metrics[Metric::kJointEffortMaxRatio],
      found.task.scenario.robot->estimated_rotors.empty()
          ? ""
          : ".\nEven if the rotor inertia is a third of the estimate, or three times the estimate, the arm "
            "uses at most\n0.9 of these limits"));
}

/// "velocity limit of a, b; inertia of c"
std::string named(const MissingData& missing) {
  std::vector<std::string> lacks;
  const auto add = [&lacks](const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) lacks.push_back(fmt::format("{} of {}", what, fmt::join(names, ", ")));
  };
  add("position limits", missing.position);
  add("velocity limit", missing.velocity);
  add("effort limit", missing.effort);
  add("inertia", missing.inertia);
  std::vector<std::string> impossible;
  for (const ImpossibleInertia& link : missing.impossible) impossible.push_back(link.link);
  add("physically possible inertia", impossible);
  return fmt::format("{}", fmt::join(lacks, "; "));
}

/// For an arm that lacks nothing: what could stand in place of what is doubted.
void write_proposals(const RobotFile& file, const std::string& urdf, const std::string& path) {
  const std::vector<Doubt> found = doubts_with_proposals(*load_robot(file.path));
  if (found.empty()) {
    say(fmt::format("{} has no missing and no doubtful values; {} was not written\n", file.path, path));
    return;
  }
  refuse_existing(path);
  write_text_file(path, proposals_yaml(urdf, found));
  say(
      fmt::format("{}: no value is missing in {}; the new file lists doubtful values and proposals, as "
                  "comments{}\n",
                  path, file.path, file.root ? ". Add the proposals that you accept to the robot file" : ""));
}

void write_sidecar(const RobotFile& file, const MissingData& missing, const std::string& path) {
  const std::string urdf = file.root ? "" : absolute_path(file.urdf);
  if (missing.empty()) return write_proposals(file, urdf, path);
  refuse_existing(path);
  write_text_file(path, missing_yaml(urdf, missing));
  MissingData to_fill_in = missing;
  to_fill_in.impossible.clear();
  say(fmt::format("{}: ", path));
  if (!to_fill_in.empty()) say(fmt::format("fill in {}; ", named(to_fill_in)));
  for (const ImpossibleInertia& link : missing.impossible) {
    say(fmt::format("check the proposed inertia of {}, which differs by {:.2g} % from the URDF; ", link.link,
                    100.0 * link.moved));
  }
  say(file.root ? fmt::format("then add the values to {}\n", file.path)
                : "then use this file as the robot file\n");
}

/// Loads and shows it, or says all that it lacks.
void look_at(const std::string& name_or_path, const std::string& sidecar, const std::string& task,
             const TaskOptions& options) {
  const RobotFile file = read_robot_file(name_or_path);
  const MissingData missing = missing_data(file.urdf, file.options);
  if (!sidecar.empty()) return write_sidecar(file, missing, sidecar);
  if (missing.empty()) {
    const auto robot = load_robot(name_or_path);
    show(*robot);
    if (!task.empty()) make_task(name_or_path, options, task);
    return;
  }
  MissingData to_fill_in = missing;
  to_fill_in.impossible.clear();
  throw InputError(fmt::format("{}: missing: {}. The option --sidecar arm.yaml writes a robot YAML {}",
                               file.path, named(missing),
                               to_fill_in.empty() ? "with the nearest physically possible inertia"
                                                  : "where you can fill in these values"));
}

void list_bundled() {
  say(fmt::format("{:<10}{:>7}{:>12}  {}\n", "robot", "joints", "reach [m]", "rotor inertia"));
  for (const std::string& name : bundled_names("robots")) {
    const auto robot = load_robot(name);
    say(fmt::format("{:<10}{:>7}{:>12.3g}  {}\n", name, robot->n(), reach(*robot),
                    robot->estimated_rotors.empty() ? "given" : "estimated"));
  }
  say("\n'armtune robot NAME' shows one of them, 'armtune robot FILE.urdf' an arm of your own.\n");
}

}  // namespace

void add_robot_command(CLI::App& app, int&) {
  auto file = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "robot", "Show the joints, limits, masses and reach of a robot file, and what the file lacks");
  command->add_option(
      "ROBOT", *file,
      "a bundled robot such as ur10, a robot YAML, or a URDF without xacro macros; without ROBOT, the "
      "bundled robots are listed");
  auto sidecar = std::make_shared<std::string>();
  command->add_option("--sidecar", *sidecar,
                      "new robot YAML in which you fill in the values that the URDF lacks (limits, inertia). "
                      "If no value is missing, the file has proposals for doubtful values");
  auto task = std::make_shared<std::string>();
  command
      ->add_option("--task", *task,
                   "new folder for a first task: a scenario with a circular path, start gains with which the "
                   "simulated arm completes this scenario, and a study that tunes these gains")
      ->excludes("--sidecar");
  auto options = std::make_shared<TaskOptions>();
  command
      ->add_option(
          "--floor", options->floor,
          "height of the floor above the base frame [m] (default: 0 for an upright arm, otherwise no floor)")
      ->needs("--task");
  command->footer([] { return std::string("Example:\n  armtune robot panda --task runs/first\n"); });
  command->callback([file, sidecar, task, options] {
    if (!file->empty()) return look_at(*file, *sidecar, *task, *options);
    if (!sidecar->empty() || !task->empty())
      throw InputError("robot: --sidecar and --task need a robot; give its name or file as ROBOT");
    list_bundled();
  });
}

}  // namespace armtune::internal::cli
