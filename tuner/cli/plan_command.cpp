// armtune plan: a trajectory offline, the best that the arm's limits allow.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>

#include "core/common/error.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/planning/output/plan_facts.hpp"
#include "tuner/planning/output/plan_files.hpp"
#include "tuner/planning/output/ros_trajectory.hpp"
#include "tuner/planning/output/scenario_file.hpp"
#include "tuner/planning/output/worst_violation.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"
#include "tuner/report/plan_recording.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/session/report_files.hpp"

namespace armtune::cli {
namespace {

struct Arguments {
  std::string task;
  std::string folder;
  int knots = 0;
  double duration = 0.0;
  int ros = 2;
};

constexpr std::size_t kShownLimits = 4;

std::string tasks() {
  std::string text;
  for (const std::string& name : bundled_names("tasks")) {
    text += fmt::format("  {:26} {}\n", name, load_plan_task(name).description);
  }
  return text;
}

/// The limit, and what breaks it where something does.
std::string value_words(const BindingLimit& limit) {
  const std::string unit = limit.unit.empty() ? "" : " " + limit.unit;
  const std::string value = fmt::format("{:.4g}", limit.value);
  const std::string bound = fmt::format("{:.4g}", limit.bound);
  return value == bound ? bound + unit : fmt::format("{}{} where {} is the limit", value, unit, bound);
}

std::string limits_text(const std::vector<BindingLimit>& limits, const char* title) {
  std::string text = fmt::format("{}{}\n", title, limits.empty() ? " nothing" : "");
  for (std::size_t i = 0; i < std::min(limits.size(), kShownLimits); ++i) {
    const BindingLimit& limit = limits[i];
    text += fmt::format("  {}: {}, {:.3g} % of the knots, {:.3f} .. {:.3f} s\n",
                        report::limit_words(limit.limit, limit.part), value_words(limit), 100.0 * limit.share,
                        limit.first, limit.last);
  }
  if (limits.size() > kShownLimits) text += fmt::format("  and {} more\n", limits.size() - kShownLimits);
  return text;
}

/// Beside the knots' own file: what is looked at, even in time and fine enough for smooth plots.
constexpr int kMotionRows = 1001;

void write_files(const Arguments& args, const PlanTask& task, const PlanProblem& problem,
                 const PlannedTrajectory& planned, const std::vector<LimitUse>& uses, double seconds) {
  const RobotModel& robot = *problem.robot;
  write_text_file(args.folder + "/task.yaml", plan_task_yaml(task));
  write_text_file(args.folder + "/trajectory.csv", trajectory_csv(task, problem, planned.trajectory));
  write_text_file(args.folder + "/motion.csv", motion_csv(task, problem, planned.trajectory, kMotionRows));
  write_text_file(args.folder + "/limits.csv", limits_csv(uses));
  write_text_file(args.folder + "/columns.csv",
                  columns_csv({{"trajectory.csv", described(trajectory_columns(task, robot))},
                               {"motion.csv", described(motion_columns(task, robot))},
                               {"limits.csv", limits_columns()}}));
  write_text_file(
      args.folder + "/joint_trajectory.yaml",
      ros_trajectory(robot, planned.trajectory, args.ros == 1 ? RosVersion::kRos1 : RosVersion::kRos2,
                     {"trajectory_msgs/JointTrajectory by armtune plan, task " + task.name,
                      "Nothing here knows the arm's surroundings or its own links: run it slowly first."}));
  write_text_file(args.folder + "/" + planned_scenario_name(task), planned_scenario_yaml(task));
  Provenance p;
  p.command = command_line();
  p.inputs = {task.source};
  if (!task.start.rollout.empty()) p.inputs.push_back(task.start.rollout);
  add_inputs({task.scenario}, p.inputs);
  p.wall_seconds = seconds;
  p.extra = plan_entries(task, problem, planned, uses);
  write_provenance(args.folder, p);
}

/// The arm, the tool's path where the task has one, and the obstacles with the clearance that is kept.
report::Scene scene_of_plan(const PlanTask& task) {
  report::Scene scene = report::scene_of({task.scenario}, {{"plan", ".", ""}}, task.clearance);
  report::SceneScenario& shown = scene.scenarios.front();
  shown.name = task.name;
  if (!tool_demands(task).path) shown.path = {};
  return scene;
}

[[nodiscard]] int infeasible(const PlanTask& task, const PlannedTrajectory& planned) {
  if (planned.too_short)
    say(fmt::format("{}: infeasible: it takes {:.6g} s at least within the limits, and was given {:.6g} s\n",
                    task.name, planned.trajectory.durations.front(), *task.duration));
  else
    say(fmt::format("{}: infeasible: {}\n", task.name, sentence(worst_violation(planned))));
  say(limits_text(binding_limits(planned),
                  planned.too_short ? "the least time is held back by:" : "in the way:"));
  say(fmt::format("Give it {}, or, where little is missing, --knots above {};\nno trajectory was written.\n",
                  planned.too_short ? "more time, wider limits or tolerances"
                                    : "wider limits or tolerances, another start",
                  planned.trajectory.time.size() - 1));
  return kChecksFailed;
}

std::string plan_text(const PlanTask& task, const PlanProblem& problem, const PlannedTrajectory& planned,
                      const std::vector<LimitUse>& uses, double seconds) {
  std::string text = fmt::format("{}: {}\n", task.name, plan_headline(task, problem, planned));
  for (const std::string& note : plan_notes(task, problem, planned)) text += note + '\n';
  text += limits_text(binding_limits(planned), "held back by:");
  if (const std::string between = between_words(uses); !between.empty()) text += between + '\n';
  const SequentialQuadraticProgress& last = planned.result.last;
  return text + fmt::format(
                    "{} intervals between knots, {} interior point steps on all grids, {:.2f} s; constraint "
                    "violation {:.1e} of the limit, KKT residual {:.1e}\n",
                    planned.trajectory.time.size() - 1, planned.interior_iterations, seconds, last.violation,
                    std::max(last.stationarity, last.complementarity));
}

int run(const Arguments& args) {
  PlanTask task = load_plan_task(args.task);
  if (args.knots > 0) task.knots = args.knots;
  if (args.duration > 0.0) task.duration = args.duration;
  const std::string folder = args.folder.empty() ? default_run_folder(task.name) : args.folder;
  refuse_used_folder(folder);  // before the work, not after it
  const auto began = std::chrono::steady_clock::now();
  ProgressLine line;
  line.show("first guess by inverse kinematics");
  const PlanProblem problem = plan_problem(task);
  const PlannedTrajectory planned = solve_plan(problem, {}, [&](const SequentialQuadraticProgress& at) {
    line.show(fmt::format("{} knots, step {}: objective {:.6g}, violation {:.1e}, KKT residual {:.1e}",
                          at.knots, at.iteration, at.objective, at.violation,
                          std::max(at.stationarity, at.complementarity)));
    return !stop_requested();
  });
  line.clear();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const SequentialQuadraticProgress& last = planned.result.last;
  switch (planned.result.status) {
    case PlanStatus::kInterrupted:
      say(fmt::format("{}: interrupted; no trajectory was written\n", task.name));
      return kInterrupted;
    case PlanStatus::kInfeasible:
      return infeasible(task, planned);
    case PlanStatus::kStalled:
      fmt::print(
          stderr,
          "{}: no solution after {} steps, nor proof that there is none: violation {:.1e} ({}), KKT "
          "residual {:.1e}; another number of --knots, wider limits or tolerances or another start may "
          "help\n",
          task.name, last.iteration, last.violation, sentence(worst_violation(planned)),
          std::max(last.stationarity, last.complementarity));
      return kFailed;
    case PlanStatus::kSolved:
      break;
  }
  const std::vector<LimitUse> uses = limit_uses(task, problem, planned);
  Arguments out = args;
  out.folder = folder;
  const FolderLock lock = make_run_folder(folder);
  write_files(out, task, problem, planned, uses, seconds);
  SessionPrinter<> printer;
  std::string report;
  for (const std::string& page : add_report(
           folder, [&task] { return scene_of_plan(task); }, printer))
    report += ", " + page;
  say(plan_text(task, problem, planned, uses, seconds));
  say(fmt::format(
      "wrote {}: trajectory.csv, motion.csv, limits.csv, joint_trajectory.yaml, task.yaml, columns.csv, "
      "run.yaml, {}{}\n",
      folder, planned_scenario_name(task), report));
  say(fmt::format("armtune simulate {}/{} follows it\n", folder, planned_scenario_name(task)));
  return kDone;
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
  command->footer([] {
    return "Tasks: move (point to point), track (path and gaze, least error), switch (gaze to the next "
           "target), return "
           "(onto the\nmoving path), fastest (along the path's curve). Limits: joint positions, velocities "
           "and torques of "
           "the robot's file,\nand accelerations and jerks where the task gives some. Under jerk limits an "
           "arm at rest has no "
           "acceleration; one that\nmoves begins with any, unless start/acceleration is given. Torque, tool "
           "path, "
           "gaze and "
           "distances are held at the knots; what\nthey do between them is printed, and in limits.csv. The "
           "folder also has "
           "motion.csv (the motion at even times) and\nreport.html with replay and limits. Nothing here "
           "knows the arm's "
           "surroundings or its own links: run a trajectory\nslowly first.\n\nBundled tasks:\n" +
           tasks() +
           "\nExample, and the plan followed in simulation:\n  armtune plan ur10_switch --out runs/switch\n"
           "  armtune simulate runs/switch/planned_ur10_switch.yaml\n";
  });
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::cli
