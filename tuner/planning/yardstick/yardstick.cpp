#include "tuner/planning/yardstick/yardstick.hpp"

#include <algorithm>
#include <cmath>

#include "core/trajectory/gaze.hpp"
#include "tuner/planning/output/binding_limits.hpp"
#include "tuner/planning/tasks/plan_start.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"
#include "tuner/record/words.hpp"

namespace armtune::internal {
namespace {

constexpr double kToleranceRoom = 1.05;     // a plan's path tolerance relative to the rollout's path error
constexpr double kClearanceRoom = 1e-6;     // m, subtracted from the rollout's least distance from obstacles
constexpr double kLongestInterval = 0.025;  // s, longest interval of a lap's time grid
// s, the same if the target switches during the lap. The error then comes from motions of tens of ms.
constexpr double kLongestWithSwitch = 0.0125;
constexpr double kAtOnce = 1.001;       // plans up to this many times the shortest duration count as 0 s
constexpr double kShortestHold = 0.02;  // s

/// Returns the longest interval of a lap's time grid [s].
double lap_interval(const Event& event, const Scenario& scenario) {
  return scenario.next_switch(event.time) < event.end ? kLongestWithSwitch : kLongestInterval;
}

std::string strongest_limit(const PlannedTrajectory& planned) {
  const std::vector<BindingLimit> limits = binding_limits(planned);
  for (const BindingLimit& limit : limits) {
    if (limit.limit == kept_words::kGaze || limit.limit == kept_words::kToolPath)
      continue;  // requirements of the task, not limits of the arm
    return limit.limit + " of " + limit.part;
  }
  return {};
}

MeasureStatus status_of(PlanStatus status) {
  switch (status) {
    case PlanStatus::kSolved:
      return MeasureStatus::kSolved;
    case PlanStatus::kInfeasible:
      return MeasureStatus::kInfeasible;
    case PlanStatus::kStalled:
      return MeasureStatus::kNotSolved;
    case PlanStatus::kInterrupted:
      return MeasureStatus::kInterrupted;
  }
  return MeasureStatus::kNotSolved;
}

/// Makes one plan for the event. Returns its status, its limit and the strongest active limit of the arm.
Measure planned_measure(const PlanTask& task, const Event& event, const PlanObserver& observer) {
  Measure found;
  found.scenario = task.scenario.name;
  found.event = event;
  found.limit = NAN;
  found.clearance = task.clearance > 0.0 ? task.clearance : NAN;
  PlanProblem problem;
  try {
    problem = plan_problem(task);
  } catch (const OutOfReach&) {
    if (!event.position.allFinite() || !event.velocity.allFinite()) throw;
    found.status = MeasureStatus::kInfeasible;  // the arm cannot reach the path
    found.held_back_by = "reach of the arm";
    return found;
  }
  const PlannedTrajectory planned = solve_plan(problem, {}, observer);
  found.status = status_of(planned.result.status);
  if (found.status == MeasureStatus::kInterrupted) return found;
  found.held_back_by = strongest_limit(planned);
  if (found.status != MeasureStatus::kSolved) return found;
  if (event.kind == EventKind::kLap) {
    found.limit = gaze_rms(task.scenario, *problem.robot, planned.trajectory, event.times);
    return found;
  }
  found.limit = planned.trajectory.durations.front();
  if (found.limit <= kAtOnce * problem.grid.phases.front().shortest) {
    found.limit = 0.0;  // the shortest duration of the grid: the goal is met from the start
    found.status = MeasureStatus::kThereAtOnce;
    found.held_back_by.clear();
  }
  return found;
}

}  // namespace

std::string words(MeasureStatus status) {
  switch (status) {
    case MeasureStatus::kSolved:
      return kept_words::kSolved;
    case MeasureStatus::kWithoutClearance:
      return "solved without obstacles";
    case MeasureStatus::kPastNextSwitch:
      return "past the next switch";
    case MeasureStatus::kThereAtOnce:
      return kept_words::kThereAtOnce;
    case MeasureStatus::kInfeasible:
      return kept_words::kInfeasible;
    case MeasureStatus::kNotSolved:
      return "not solved";
    case MeasureStatus::kInterrupted:
      return "interrupted";
  }
  return {};
}

double Measure::ratio() const {
  return limit > 0.0 ? event.reached / limit : NAN;
}

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
  if (options.clearance > 0.0 && !scenario.obstacles.empty())
    task.clearance = std::max(0.0, std::min(options.clearance, event.nearest - kClearanceRoom));
  // The rollout's distance from obstacles (event.nearest) is measured at the tool and the joint origins, so
  // the plan does not check the shapes of the links against obstacles either.
  if (scenario.clearance)
    task.scenario.clearance = std::make_shared<const ClearanceModel>(scenario.clearance->without_obstacles());
  switch (event.kind) {
    case EventKind::kSwitch:
      task.kind = PlanKind::kSwitch;
      task.hold = kSwitchHold;
      // The plan need not stay on target beyond the end of the controller's event.
      if (event.outcome == EventOutcome::kReached)
        task.hold = std::clamp(event.end - event.time - event.reached, kShortestHold, kSwitchHold);
      break;
    case EventKind::kReturn:
      task.kind = PlanKind::kReturn;
      break;
    case EventKind::kLap:
      task.kind = PlanKind::kTrack;
      task.duration = event.end - event.time;
      task.knots =
          std::max(task.knots, static_cast<int>(std::ceil(*task.duration / lap_interval(event, scenario))));
      break;
  }
  return task;
}

double gaze_rms(const Scenario& scenario, const RobotModel& robot, const Trajectory& trajectory,
                const std::vector<double>& times) {
  const MovingPoint target = active_target(scenario);
  Poses poses;
  double sum = 0.0;
  for (const double t : times) {
    forward_kinematics(robot.chain, JointVector(point_at(trajectory, t).position), poses);
    const double angle = gaze_angle(poses.R_0T, poses.p_0T, target(t).position);
    sum += angle * angle;
  }
  return std::sqrt(sum / static_cast<double>(times.size()));
}

Measure measure(const Event& event, const Scenario& scenario, const YardstickOptions& options,
                const PlanObserver& observer) {
  if (event.kind == EventKind::kSwitch && event.gaze < options.gaze_threshold) {
    // The gaze is on target from the start, so the limit is 0, however long the controller took.
    Measure found;
    found.scenario = scenario.name;
    found.event = event;
    found.status = MeasureStatus::kThereAtOnce;
    found.clearance = NAN;
    return found;
  }
  PlanTask task = task_of(event, scenario, options);
  Measure found = planned_measure(task, event, observer);
  const bool failed = found.status == MeasureStatus::kInfeasible || found.status == MeasureStatus::kNotSolved;
  if (failed && task.clearance > 0.0) {
    task.clearance = 0.0;
    found = planned_measure(task, event, observer);
  }
  const bool obstacles = options.clearance > 0.0 && !scenario.obstacles.empty();
  if (found.status == MeasureStatus::kSolved && obstacles && task.clearance == 0.0)
    found.status = MeasureStatus::kWithoutClearance;
  if (event.kind == EventKind::kSwitch && found.limit > 0.0 &&
      event.time + found.limit > scenario.next_switch(event.time))
    found.status = MeasureStatus::kPastNextSwitch;
  return found;
}

double reacquisition_limit(const std::vector<Measure>& measures, const std::string& scenario) {
  const Measure* slowest = nullptr;
  for (const Measure& m : measures) {
    if (m.event.kind != EventKind::kSwitch || m.scenario != scenario) continue;
    if (slowest == nullptr || m.event.settled > slowest->event.settled) slowest = &m;
  }
  return slowest == nullptr ? NAN : slowest->limit;
}

}  // namespace armtune::internal
