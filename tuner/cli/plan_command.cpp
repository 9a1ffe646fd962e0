// armtune plan: a trajectory offline, the best that the arm's limits allow.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>

#include "core/common/error.hpp"
#include "sim/csv/error_report.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/planning/output/binding_limits.hpp"
#include "tuner/planning/output/plan_files.hpp"
#include "tuner/planning/output/worst_violation.hpp"
#include "tuner/run/run_folder.hpp"

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

void show_limits(const std::vector<BindingLimit>& limits, const char* title) {
  fmt::print("{}{}\n", title, limits.empty() ? " nothing" : "");
  for (std::size_t i = 0; i < std::min(limits.size(), kShownLimits); ++i) {
    const BindingLimit& limit = limits[i];
    fmt::print("  {} of {}: {:.3g} % of the knots, {:.3f} .. {:.3f} s\n", limit.limit, limit.part,
               100.0 * limit.share, limit.first, limit.last);
  }
  if (limits.size() > kShownLimits) fmt::print("  and {} more\n", limits.size() - kShownLimits);
}

/// What a solved plan has reached, in a sentence.
std::string headline(const PlanTask& task, const PlannedTrajectory& planned) {
  const double duration = planned.trajectory.durations.front();
  if (!task.duration)
    return fmt::format("{}: {:.4g} s is the least time found within the limits", task.name, duration);
  return fmt::format("{}: solved over {:.4g} s", task.name, duration);
}

void write_files(const Arguments& args, const PlanTask& task, const PlanProblem& problem,
                 const PlannedTrajectory& planned, double seconds) {
  const RobotModel& robot = *problem.robot;
  const bool path_coordinate = planned.trajectory.position.rows() > robot.n();
  write_text_file(args.folder + "/task.yaml", plan_task_yaml(task));
  write_text_file(args.folder + "/trajectory.csv", trajectory_csv(task, problem, planned.trajectory));
  write_text_file(args.folder + "/columns.csv",
                  columns_csv({{"trajectory.csv", trajectory_columns(robot, path_coordinate)}}));
  write_text_file(
      args.folder + "/joint_trajectory.yaml",
      ros_trajectory(robot, planned.trajectory, args.ros == 1 ? RosVersion::kRos1 : RosVersion::kRos2,
                     {"trajectory_msgs/JointTrajectory by armtune plan, task " + task.name,
                      "Nothing here knows the arm's surroundings or its own links: run it slowly first."}));
  const SequentialQuadraticProgress& last = planned.result.last;
  Provenance p;
  p.command = command_line();
  p.inputs = {task.source};
  add_inputs({task.scenario}, p.inputs);
  p.wall_seconds = seconds;
  p.extra = {{"duration", fmt::format("{:.17g}", planned.trajectory.durations.front())},
             {"violation", fmt::format("{:.3g}", last.violation)},
             {"kkt_stationarity", fmt::format("{:.3g}", last.stationarity)},
             {"kkt_complementarity", fmt::format("{:.3g}", last.complementarity)},
             {"interior_point_steps", std::to_string(planned.interior_iterations)}};
  write_text_file(args.folder + "/run.yaml", run_yaml(p));
}

[[nodiscard]] int infeasible(const PlanTask& task, const PlannedTrajectory& planned) {
  fmt::print("{}: infeasible: {}\n", task.name, sentence(worst_violation(planned)));
  show_limits(binding_limits(planned), "in the way:");
  fmt::print("Give it more time, wider limits or tolerances, or another start; no trajectory was written.\n");
  return kNoFeasiblePoint;
}

int run(const Arguments& args) {
  PlanTask task = load_plan_task(args.task);
  if (args.knots > 0) task.knots = args.knots;
  if (args.duration > 0.0) task.duration = args.duration;
  const std::string folder = args.folder.empty() ? default_run_folder(task.name) : args.folder;
  refuse_used_folder(folder);  // before the work, not after it
  const auto began = std::chrono::steady_clock::now();
  const PlanProblem problem = plan_problem(task);
  ProgressLine line;
  const PlannedTrajectory planned = solve_refining(
      problem.task, problem.grid, problem.guess, {}, [&](const SequentialQuadraticProgress& at) {
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
      fmt::print("{}: interrupted; no trajectory was written\n", task.name);
      return kInterrupted;
    case PlanStatus::kInfeasible:
      return infeasible(task, planned);
    case PlanStatus::kStalled:
      fmt::print(stderr,
                 "{}: no solution after {} steps: violation {:.1e} ({}), KKT residual {:.1e}; give fewer "
                 "knots, more "
                 "smoothness or a start closer to the path\n",
                 task.name, last.iteration, last.violation, sentence(worst_violation(planned)),
                 std::max(last.stationarity, last.complementarity));
      return kFailed;
    case PlanStatus::kSolved:
      break;
  }
  fmt::print("{}\n", headline(task, planned));
  show_limits(binding_limits(planned), "held back by:");
  fmt::print(
      "{} knots, {} interior point steps on all grids, {:.2f} s; constraint violation {:.1e} of the limit, "
      "KKT "
      "residual {:.1e}\n",
      planned.trajectory.time.size(), planned.interior_iterations, seconds, last.violation,
      std::max(last.stationarity, last.complementarity));
  Arguments out = args;
  out.folder = folder;
  make_run_folder(folder);
  write_files(out, task, problem, planned, seconds);
  fmt::print("wrote {}: trajectory.csv, joint_trajectory.yaml, task.yaml, columns.csv, run.yaml\n", folder);
  return kDone;
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "plan", "Plan a trajectory offline: the least time or error that the arm's limits allow");
  command->add_option("TASK", args->task, "bundled task, or a task file")->required();
  command->add_option("--out", args->folder, "new folder for trajectory.csv and joint_trajectory.yaml");
  command->add_option("--knots", args->knots, "time grid, in place of the task's")
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
           "and torques of the "
           "robot's file,\nand accelerations and jerks where the task gives some. Nothing here knows the "
           "arm's surroundings "
           "or its own links:\nrun a trajectory slowly first.\n\nBundled tasks:\n" +
           tasks() + "\nExample:\n  armtune plan ur10_switch --out runs/switch\n";
  });
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::cli
