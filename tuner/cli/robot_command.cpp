// The command `armtune robot`, which shows an arm. It can also write a file for missing values, and a first
// task.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "armtune/error.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/robot_printer.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/cli/sidecar.hpp"
#include "tuner/first_task/first_task.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal::cli {
namespace {

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
        "collisions, source the ROS workspace that has the meshes, give their folder in ARMTUNE_MESHES, or give "
        "'shapes' in a robot YAML");
  say(fmt::format(
      "\nwrote {0}: {1}task.yaml (a circle with a radius of {2:.3g} m), gains.yaml, study.yaml\n"
      "With these gains the arm completes the task in Simbody, with at most {3:.2g} of its velocity limits\n"
      "and {4:.2g} of its effort limits{5}.\n"
      "In the native engine, which is armtune's own dynamics, it keeps its limits for 30 minutes. In one\n"
      "run of the task in this engine, nearly all of 60 randomly changed arms keep their position and\n"
      "velocity limits, and their torques saturate in at most 1 % of the control periods.\n"
      "next: armtune tune {0}/study.yaml\n",
      folder, found.robot_yaml.empty() ? "" : "robot.yaml (rotor inertia estimated), ",
      found.task.scenario.path.terms[0].cosine.norm(), found.metrics[Metric::kJointVelocityMaxRatio],
      found.metrics[Metric::kJointEffortMaxRatio],
      found.task.scenario.robot->estimated_rotors.empty()
          ? ""
          : ".\nEven if the rotor inertia is a third of the estimate, or three times the estimate, the arm "
            "uses at most\n0.9 of these limits"));
}

/// Shows the arm, and writes the first task if asked for. Throws InputError that names all missing values, if
/// there are any. With `sidecar`, only writes that file.
void look_at(const std::string& name_or_path, const std::string& sidecar, const std::string& task,
             const TaskOptions& options) {
  const RobotFile file = read_robot_file(name_or_path);
  if (!sidecar.empty()) return write_sidecar(file, sidecar);
  const MissingData missing = missing_data(file.urdf, file.options);
  if (missing.empty()) {
    const auto robot = load_robot(name_or_path);
    show_robot(*robot);
    if (!task.empty()) make_task(name_or_path, options, task);
    return;
  }
  throw InputError(
      InputPlace{file.path},
      fmt::format("missing: {}. The option --sidecar arm.yaml writes a robot YAML {}", named(missing),
                  to_fill_in(missing).empty() ? "with the nearest physically possible inertia"
                                              : "where you can fill in these values"));
}

}  // namespace

void add_robot_command(CLI::App& app, int&) {
  auto file = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "robot", "Show the joints, limits, masses and reach of a robot file, and what the file lacks");
  command->add_option(
      "ROBOT", *file,
      "a bundled robot such as ur10, a robot YAML, or a URDF (or a xacro file with --xacro); without "
      "ROBOT, the bundled robots are listed");
  auto sidecar = std::make_shared<std::string>();
  command->add_option("--sidecar", *sidecar,
                      "new robot YAML in which you fill in the values that the URDF lacks (limits, inertia). "
                      "It also has proposals for doubtful values, as comments");
  auto task = std::make_shared<std::string>();
  command
      ->add_option("--task", *task,
                   "new folder for a first task: a scenario with a circular path, start gains with which the "
                   "simulated arm completes this scenario, and a study that tunes these gains")
      ->excludes("--sidecar");
  auto options = std::make_shared<TaskOptions>();
  command->add_option("--floor", options->floor, "height of the floor above the base frame [m]")
      ->default_str("0 for an upright arm, otherwise no floor")
      ->needs("--task");
  command->footer([] { return std::string("Example:\n  armtune robot panda --task runs/first\n"); });
  command->callback([file, sidecar, task, options] {
    if (!file->empty()) return look_at(*file, *sidecar, *task, *options);
    if (!sidecar->empty() || !task->empty())
      throw InputError("robot: --sidecar and --task need a robot; give its name or file as ROBOT");
    list_bundled_robots();
  });
}

}  // namespace armtune::internal::cli
