#include "tuner/planning/session/plan_session.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/csv/text_file.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/rollout/motion_bag.hpp"
#include "tuner/planning/output/contact_note.hpp"
#include "tuner/planning/output/plan_facts.hpp"
#include "tuner/planning/output/plan_files.hpp"
#include "tuner/planning/output/scenario_file.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/write_run_record.hpp"
#include "tuner/session/report_files.hpp"

namespace armtune::internal {
namespace {

/// Number of rows of motion.csv. They are equally spaced in time, and close enough for smooth plots.
constexpr int kMotionRows = 1001;

/// Returns what the report shows: the arm, the tool's path if the task has one, and the obstacles with the
/// required clearance.
report::Scene scene_of_plan(const PlanTask& task) {
  report::Scene scene = report::scene_of({task.scenario}, {{"plan", ".", ""}}, task.clearance);
  report::SceneScenario& shown = scene.scenarios.front();
  shown.name = task.name;
  if (!tool_demands(task).path) shown.path = {};
  return scene;
}

}  // namespace

PlanSession::PlanSession(PlanSettings settings, SessionContext context, SessionObserver& observer)
    : settings_(std::move(settings)), context_(std::move(context)), observer_(observer) {}

PlanOutcome PlanSession::run() {
  if (!settings_.folder.empty()) refuse_used_folder(settings_.folder);  // before the work, not after it
  const Stopwatch watch;
  observer_.progressed({"first guess by inverse kinematics"});
  outcome_.problem = plan_problem(settings_.task);
  outcome_.planned = solve_plan(*outcome_.problem, {}, [this](const SequentialQuadraticProgress& at) {
    observer_.progressed({fmt::format(
        "{} knots, step {}: objective {:.6g}, violation {:.1e}, KKT residual {:.1e}", at.knots, at.iteration,
        at.objective, at.violation, std::max(at.stationarity, at.complementarity))});
    return !context_.stop;
  });
  observer_.part_is_over();
  outcome_.seconds = watch.seconds();
  if (outcome_.planned.result.status != PlanStatus::kSolved) return std::move(outcome_);
  outcome_.uses = limit_uses(settings_.task, *outcome_.problem, outcome_.planned);
  const FolderLock lock = make_run_folder(settings_.folder);
  if (!settings_.folder.empty()) write_files();
  return std::move(outcome_);
}

void PlanSession::write_files() {
  const std::string& folder = settings_.folder;
  const PlanTask& task = settings_.task;
  const PlanProblem& problem = *outcome_.problem;
  const PlannedTrajectory& planned = outcome_.planned;
  const RobotModel& robot = *problem.robot;
  write_text_file(folder + "/task.yaml", plan_task_yaml(task));
  write_text_file(folder + "/trajectory.csv", trajectory_csv(task, problem, planned.trajectory));
  write_text_file(folder + "/motion.csv", motion_csv(task, problem, planned.trajectory, kMotionRows));
  if (settings_.mcap) {
    write_motion_bag(folder + "/motion.mcap", {robot, column_names(described(motion_columns(task, robot))),
                                               motion_rows(task, problem, planned.trajectory, kMotionRows)});
  }
  write_text_file(folder + "/limits.csv", limits_csv(outcome_.uses));
  write_text_file(folder + "/columns.csv",
                  columns_csv({{"trajectory.csv", described(trajectory_columns(task, robot))},
                               {"motion.csv", described(motion_columns(task, robot))},
                               {"limits.csv", limits_columns()}}));
  write_text_file(folder + "/joint_trajectory.yaml",
                  ros_trajectory(robot, planned.trajectory, settings_.ros,
                                 {"trajectory_msgs/JointTrajectory by armtune plan, task " + task.name,
                                  contact_note(task) + " Run the motion slowly first."}));
  write_text_file(folder + "/" + planned_scenario_name(task), planned_scenario_yaml(task));
  RunRecord record;
  record.kind = RunKind::kPlan;
  record.command = context_.invocation.line;
  record.wall_seconds = outcome_.seconds;
  record.plan = plan_facts(task, problem, planned, outcome_.uses);
  FilesRead files{{task.source}};
  if (!task.start.rollout.empty()) files.inputs.push_back(task.start.rollout);
  add_inputs({task.scenario}, files.inputs);
  write_run_record(folder, std::move(record), files);
  outcome_.files = {"trajectory.csv", "motion.csv",  "limits.csv", "joint_trajectory.yaml",
                    "task.yaml",      "columns.csv", kRunRecord,   planned_scenario_name(task)};
  if (settings_.mcap) outcome_.files.emplace_back("motion.mcap");
  const auto pages = add_report(
      folder, [&task] { return scene_of_plan(task); }, observer_);
  outcome_.files.insert(outcome_.files.end(), pages.begin(), pages.end());
}

}  // namespace armtune::internal
