// armtune plan: a trajectory offline, the best that the arm's limits allow.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "sim/scenario/data_files.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/plan_printer.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal::cli {
namespace {

struct Arguments {
  std::string task;
  std::string folder;
  int knots = 0;
  double duration = 0.0;
  int ros = 2;
};

std::string tasks() {
  std::string text;
  for (const std::string& name : bundled_names("tasks")) {
    text += fmt::format("  {:26} {}\n", name, load_plan_task(name).description);
  }
  return text;
}

constexpr const char* kFooter =
    "Tasks: move (point to point), track (path and gaze, least error), switch (gaze to the next target), return "
    "(onto the\nmoving path), fastest (along the path's curve). Limits: joint positions, velocities and torques "
    "of the robot's file,\nand accelerations and jerks where the task gives some. Under jerk limits an arm at "
    "rest has no acceleration; one that\nmoves begins with any, unless start/acceleration is given. Torque, "
    "tool path, gaze and distances are held at the knots; what\nthey do between them is printed, and in "
    "limits.csv. The folder also has motion.csv (the motion at even times) and\nreport.html with replay and "
    "limits. In a scenario with a 'cell' the arm keeps its clearance from that and from itself; without one\n"
    "nothing is known of either. Run a trajectory slowly first.\n\n"
    "Bundled tasks:\n";
constexpr const char* kExample =
    "\nExample, and the plan followed in simulation:\n  armtune plan ur10_switch --out runs/switch\n"
    "  armtune simulate runs/switch/planned_ur10_switch.yaml\n";

int run(const Arguments& args) {
  PlanSettings settings;
  settings.task = load_plan_task(args.task);
  if (args.knots > 0) settings.task.knots = args.knots;
  if (args.duration > 0.0) settings.task.duration = args.duration;
  settings.folder = args.folder.empty() ? default_run_folder(settings.task.name) : args.folder;
  settings.ros = args.ros == 1 ? RosVersion::kRos1 : RosVersion::kRos2;
  SessionPrinter<> printer;
  return print_plan(PlanSession(settings, session_context(), printer).run(), settings);
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "plan", "Plan a trajectory offline: the least time or error that the arm's limits allow");
  command->add_option("TASK", args->task, "bundled task, or a task file")->required();
  command->add_option("--out", args->folder,
                      "new folder for trajectory.csv, joint_trajectory.yaml, report.html and the rest");
  command->add_option("--knots", args->knots, "intervals of the time grid, in place of the task's")
      ->check(CLI::Range(12, 100000));
  command->add_option("--duration", args->duration, "fixed duration [s], in place of the task's")
      ->check(CLI::Range(1e-3, 1e4));
  command->add_option("--ros", args->ros, "joint_trajectory.yaml for ROS 1 or 2")
      ->check(CLI::IsMember({1, 2}))
      ->capture_default_str();
  command->footer([] { return kFooter + tasks() + kExample; });
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::internal::cli
