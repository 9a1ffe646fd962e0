#include "tuner/planning/yardstick/yardstick.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/trajectory/gaze.hpp"
#include "sim/csv/cell.hpp"
#include "tuner/planning/tasks/plan_problem.hpp"

namespace armtune {
namespace {

constexpr double kToleranceRoom = 1.05;  // beside the rollout's own largest distance from the path

const char* word(PlanStatus status) {
  switch (status) {
    case PlanStatus::kSolved:
      return "solved";
    case PlanStatus::kInfeasible:
      return "infeasible";
    case PlanStatus::kStalled:
      return "not solved";
    case PlanStatus::kInterrupted:
      return "interrupted";
  }
  return "";
}

/// Rms of the gaze angle along a planned lap.
double gaze_rms(const Scenario& scenario, const RobotModel& robot, const Trajectory& trajectory) {
  const MovingPoint target = active_target(scenario);
  Poses poses;
  double sum = 0.0;
  for (std::size_t k = 0; k < trajectory.time.size(); ++k) {
    forward_kinematics(robot.chain, JointVector(trajectory.position.col(static_cast<Eigen::Index>(k))),
                       poses);
    const double angle = gaze_angle(poses.R_0T, poses.p_0T, target(trajectory.time[k]).position);
    sum += angle * angle;
  }
  return std::sqrt(sum / static_cast<double>(trajectory.time.size()));
}

}  // namespace

PlanTask task_of(const Event& event, const Scenario& scenario, const YardstickOptions& options) {
  PlanTask task;
  task.name = name(event.kind);
  task.source = scenario.source;
  task.scenario = scenario;
  task.at = event.time;
  task.start.position = event.position;
  task.start.velocity = event.velocity;
  task.gaze_threshold = options.gaze_threshold;
  task.path_tolerance = std::max(options.path_tolerance, kToleranceRoom * event.path_error);
  task.limits.velocity = options.velocity;
  task.limits.effort = options.effort;
  task.knots = options.knots;
  switch (event.kind) {
    case EventKind::kSwitch:
      task.kind = PlanKind::kSwitch;
      break;
    case EventKind::kReturn:
      task.kind = PlanKind::kReturn;
      break;
    case EventKind::kLap:
      task.kind = PlanKind::kTrack;
      task.duration = event.end - event.time;
      break;
  }
  return task;
}

Measure measure(const Event& event, const Scenario& scenario, const YardstickOptions& options,
                const PlanObserver& observer) {
  const PlanTask task = task_of(event, scenario, options);
  const PlanProblem problem = plan_problem(task);
  const PlannedTrajectory planned = solve_refining(problem.task, problem.grid, problem.guess, {}, observer);
  Measure found;
  found.scenario = scenario.name;
  found.event = event;
  found.status = planned.result.status;
  found.limit = NAN;
  if (found.status == PlanStatus::kSolved) {
    found.limit = event.kind == EventKind::kLap ? gaze_rms(scenario, *problem.robot, planned.trajectory)
                                                : planned.trajectory.durations.front();
  }
  const std::vector<BindingLimit> limits = binding_limits(planned);
  for (const BindingLimit& limit : limits) {
    if (limit.limit == "gaze" || limit.limit == "tool path") continue;  // what was asked for
    found.held_back_by = limit.limit + " of " + limit.part;
    break;
  }
  return found;
}

std::string yardstick_csv(const std::vector<Measure>& measures) {
  std::string text;
  for (const Column& column : yardstick_columns()) text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  for (const Measure& m : measures) {
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", m.scenario, name(m.event.kind), cell(m.event.time),
                        cell(m.event.reached), cell(m.limit), cell(m.event.reached / m.limit),
                        unit(m.event.kind), m.held_back_by, word(m.status));
  }
  return text;
}

std::vector<Column> yardstick_columns() {
  return {
      {"scenario", "", "name of the scenario", {}},
      {"event",
       "",
       "switch: time until the gaze is on the next target; return: time until the path is followed again; "
       "lap: rms of the gaze angle over one turn",
       {}},
      {"time", "s", "when it begins", {}},
      {"reached", "s, rad", "what the controller reached", {}},
      {"limit", "s, rad", "the least that the arm's limits allow from the same state on", {}},
      {"ratio", "1", "reached / limit", {}},
      {"unit", "", "of reached and limit", {}},
      {"held_back_by", "", "the limit that costs most", {}},
      {"status", "", "of the plan: solved, infeasible, not solved, interrupted", {}}};
}

}  // namespace armtune
