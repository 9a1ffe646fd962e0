// The command `armtune plan`, which plans the best trajectory that the arm's limits allow.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "sim/scenario/data_files.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/mcap_option.hpp"
#include "tuner/cli/plan_printer.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal::cli {
namespace {

struct PlanArguments {
  std::string task;
  std::string folder;
  int knots = 0;
  double duration = 0.0;
  int ros = 2;
  bool mcap = false;
};

std::string tasks() {
  std::string text;
  for (const std::string& name : bundled_names("tasks")) {
    text += fmt::format("  {:26} {}\n", name, load_plan_task(name).description);
  }
  return text;
}

constexpr const char* kFooter =
    "Kinds of tasks:\n"
    "  move     reach a joint position\n"
    "  track    follow the tool path and keep the gaze (the tool's z axis) on the targets, with the least\n"
    "           error\n"
    "  switch   turn the gaze to the next target while the tool stays on its path\n"
    "  return   move the tool back onto its moving path\n"
    "  fastest  follow the curve of the path in the least time\n\n"
    "A plan keeps the limits of joint position, velocity and torque in the robot file, and the limits of\n"
    "acceleration and jerk that the task gives. The task can also give the start acceleration, with the key\n"
    "'acceleration' under 'start'. Without this key it is zero (a) for an arm that starts at rest in a task\n"
    "with jerk limits, and (b) for a 'move' without 'start'. Otherwise the planner chooses it.\n"
    "Limits of torque, tool path, gaze and distance are kept only at the knots, which are the points of\n"
    "the time grid. How much of these limits the motion uses between the knots is printed, and listed in\n"
    "limits.csv. The folder also has motion.csv (the motion at equal time steps) and report.html (replay\n"
    "and limits). If the task's scenario has a 'cell', the plan keeps the clearance of the arm from the cell\n"
    "and from itself. Without a 'cell', these collisions are not checked. Run a trajectory slowly first.\n\n"
    "Bundled tasks:\n";
constexpr const char* kExample =
    "\nExample that plans a motion, and simulates an arm that follows it:\n"
    "  armtune plan ur10_switch --out runs/switch\n"
    "  armtune simulate runs/switch/planned_ur10_switch.yaml\n";

int run_plan(const PlanArguments& args) {
  PlanSettings settings;
  settings.task = load_plan_task(args.task);
  if (args.knots > 0) settings.task.knots = args.knots;
  if (args.duration > 0.0) settings.task.duration = args.duration;
  settings.folder = args.folder.empty() ? default_run_folder(settings.task.name) : args.folder;
  settings.ros = args.ros == 1 ? RosVersion::kRos1 : RosVersion::kRos2;
  settings.mcap = args.mcap;
  SessionPrinter<> printer;
  return print_plan(PlanSession(settings, session_context(), printer).run(), settings);
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand(
      "plan", "Plan a trajectory offline, with the least time or error that the arm's limits allow");
  command->add_option("TASK", args->task, "bundled task or task file")->required();
  command
      ->add_option("--out", args->folder,
                   "new folder for trajectory.csv, joint_trajectory.yaml, report.html and other results")
      ->default_str("runs/<task>_<time>");
  command->add_option("--knots", args->knots, "number of intervals of the time grid")
      ->default_str("as in the task")
      ->check(CLI::Range(12, 100000));
  command->add_option("--duration", args->duration, "fixed duration of the motion [s]")
      ->default_str("as in the task; if the task has no duration, the least possible")
      ->check(CLI::Range(1e-3, 1e4));
  command->add_option("--ros", args->ros, "ROS version for which joint_trajectory.yaml is written")
      ->check(CLI::IsMember({1, 2}))
      ->capture_default_str();
  add_mcap_option(*command, args->mcap);
  command->footer([] { return kFooter + tasks() + kExample; });
  command->callback([args, &exit_code] { exit_code = run_plan(*args); });
}

}  // namespace armtune::internal::cli
