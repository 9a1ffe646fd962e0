#include "tuner/planning/tasks/plan_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/trajectory/quintic.hpp"
#include "tuner/planning/tasks/fastest_problem.hpp"
#include "tuner/planning/tasks/given_states.hpp"
#include "tuner/planning/transcription/arm_terms.hpp"
#include "tuner/planning/transcription/state_term.hpp"

namespace armtune::internal {
namespace {

constexpr double kErrorWeight = 10.0;  // weight of squared errors [m^2, rad^2] relative to the jerk's cost

/// Returns a motion in which every joint follows a quintic polynomial from one state to another.
Trajectory joint_quintic(const TimeGrid& grid, const MotionPoint<JointVector>& from,
                         const MotionPoint<JointVector>& to) {
  Trajectory motion;
  const double duration = grid.phases.front().duration;
  const int intervals = grid.intervals();
  motion.durations = {duration};
  motion.position.resize(from.position.size(), intervals + 1);
  motion.velocity.resize(from.position.size(), intervals + 1);
  motion.acceleration.resize(from.position.size(), intervals + 1);
  for (Eigen::Index i = 0; i < from.position.size(); ++i) {
    const Quintic<double> quintic({from.position[i], from.velocity[i], from.acceleration[i]},
                                  {to.position[i], to.velocity[i], to.acceleration[i]}, duration);
    for (int k = 0; k <= intervals; ++k) {
      const MotionPoint<double> point = quintic.at(duration * k / intervals);
      motion.position(i, k) = point.position;
      motion.velocity(i, k) = point.velocity;
      motion.acceleration(i, k) = point.acceleration;
    }
  }
  for (int k = 0; k <= intervals; ++k) motion.time.push_back(grid.start + duration * k / intervals);
  return motion;
}

/// Returns the controller's motion on the grid, as a first guess.
Trajectory controllers(Trajectory motion, const TimeGrid& grid) {
  motion.durations.clear();
  for (const Phase& phase : grid.phases) motion.durations.push_back(phase.duration);
  return on_grid(motion, grid);
}

PlanProblem move_problem(const PlanCommon& common) {
  const JointVector zero = JointVector::Zero(common.n());
  PlanProblem problem;
  problem.grid = common.grid({common.phase(
      "move", common.task.knots,
      common.likely_duration(common.task.goal - common.start.position) + common.turning_time())});
  problem.task = [common, zero](const TimeGrid& grid) {
    TrajectoryTask program = common.on(grid);
    program.terms.push_back(given_state("goal", joint_names(*common.robot), position_units(*common.robot),
                                        grid.intervals(), {common.task.goal, zero, zero}));
    return program;
  };
  problem.guess = joint_quintic(problem.grid, {common.start.position, common.start.velocity, zero},
                                {common.task.goal, zero, zero});
  return problem;
}

PlanProblem track_problem(const PlanCommon& common) {
  PlanProblem problem;
  const double duration = *common.task.duration;
  problem.grid = common.grid({{"track", common.task.knots, duration, false}});
  problem.task = [common, duration](const TimeGrid& grid) {
    TrajectoryTask program = common.on(grid);
    const int last = grid.intervals();
    const double weight = kErrorWeight * duration / last;
    const Scenario& scenario = common.task.scenario;
    program.terms.push_back(tool_path_cost(*common.robot, {0, last}, scenario.path, weight));
    // At each knot, the cost refers to the target that is active there.
    const std::size_t targets = scenario.targets.size();
    for (std::size_t target = 0; target < targets; ++target) {
      int first = -1;
      for (int k = 0; k <= last + 1; ++k) {
        const bool active =
            k <= last && scenario.active_target(grid.start + duration * k / last + 1e-9) == target;
        if (active && first < 0) first = k;
        if (!active && first >= 0) {
          program.terms.push_back(
              gaze_cost(*common.robot, {first, k - 1}, scenario.targets[target].path, weight));
          first = -1;
        }
      }
    }
    return program;
  };
  problem.guess = follow(
      *common.robot, common.start.position, problem.grid,
      [&](double t) { return common.task.scenario.path.at(t); }, active_target(common.task.scenario));
  return problem;
}

PlanProblem switch_problem(const PlanCommon& common) {
  const Scenario& scenario = common.task.scenario;
  const Path from = scenario.targets[scenario.active_target(common.task.at - scenario.control_period)].path;
  const Path to = scenario.targets[scenario.active_target(common.task.at + scenario.control_period)].path;
  const double guess = common.first_duration(1.0);
  // Time of the next switch. The task may begin shortly before its own switch, which does not count.
  const double until = scenario.next_switch(common.task.at + scenario.control_period);
  const int holding = std::max(4, common.task.knots / 3);
  PlanProblem problem;
  problem.grid = common.task.least_error
                     ? common.grid({{"turn", common.task.knots, guess, false}})
                     : common.grid({common.phase("turn", common.task.knots - holding, guess),
                                    {"hold", holding, common.task.hold, false}});
  problem.task = [common, to](const TimeGrid& grid) {
    TrajectoryTask program = common.on(grid);
    const int last = grid.intervals();
    program.terms.push_back(
        tool_on_path(*common.robot, {1, last}, common.task.scenario.path, common.task.path_tolerance));
    if (common.task.least_error) {
      program.terms.push_back(
          gaze_cost(*common.robot, {0, last}, to, kErrorWeight * *common.task.duration / last));
    } else {
      program.terms.push_back(
          gaze_within(*common.robot, {grid.first_knot(1), last}, to, common.task.gaze_threshold));
    }
    return program;
  };
  // In the first guess, the gaze moves smoothly from one target to the other.
  problem.target_until = until;
  problem.gaze_target = [to](double t) { return to.at(t); };
  const double start = common.task.at;
  const MovingPoint blended = [from, to, start, guess](double t) {
    const double s = std::clamp((t - start) / guess, 0.0, 1.0);
    const double b = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
    const MotionPoint<Vec3> a = from.at(t);
    const MotionPoint<Vec3> c = to.at(t);
    return MotionPoint<Vec3>{(1.0 - b) * a.position + b * c.position, (1.0 - b) * a.velocity + b * c.velocity,
                             Vec3::Zero()};
  };
  problem.guess = follow(
      *common.robot, common.start.position, problem.grid, [&](double t) { return scenario.path.at(t); },
      blended);
  return problem;
}

PlanProblem return_problem(const PlanCommon& common) {
  const Scenario& scenario = common.task.scenario;
  const MovingPoint target = active_target(scenario);
  // The end point on the path depends on the duration. The second pass improves the guess of the first.
  double duration = common.first_duration(1.0);
  JointVector end;
  for (int pass = 0; pass < 2; ++pass) {
    const double at = common.task.at + duration;
    const Vec3 tool = scenario.path.at(at).position;
    const auto pose = pose_at(*common.robot, tool,
                              common.task.end_gaze ? std::optional<Vec3>(target(at).position) : std::nullopt,
                              common.start.position, BestPose::kSoonest);
    if (!pose) common.no_pose(tool);
    end = *pose;
    duration = common.first_duration(common.likely_duration(end - common.start.position));
  }
  // The target that is active at the guessed end.
  const double ending = common.task.at + duration;
  const Path gazed = scenario.targets[scenario.active_target(ending)].path;
  PlanProblem problem;
  if (common.task.end_gaze) problem.target_until = scenario.next_switch(ending);
  problem.gaze_target = [gazed](double t) { return gazed.at(t); };
  problem.grid = common.grid({common.phase("return", common.task.knots, duration)});
  problem.task = [common, gazed](const TimeGrid& grid) {
    TrajectoryTask program = common.on(grid);
    const int last = grid.intervals();
    const Scenario& in = common.task.scenario;
    program.terms.push_back(tool_on_path(*common.robot, {last, last}, in.path, 0.0));
    program.terms.push_back(tool_moves_with_path(*common.robot, last, in.path));
    if (common.task.end_gaze) {
      program.terms.push_back(gaze_within(*common.robot, {last, last}, gazed, common.task.gaze_threshold));
    }
    return program;
  };
  const JointVector zero = JointVector::Zero(common.n());
  problem.guess =
      joint_quintic(problem.grid, {common.start.position, common.start.velocity, zero}, {end, zero, zero});
  return problem;
}

}  // namespace

MovingPoint active_target(const Scenario& scenario) {
  if (scenario.targets.empty()) return [](double) { return MotionPoint<Vec3>{}; };
  return [targets = scenario.targets, scenario](double t) {
    return targets[scenario.active_target(std::max(0.0, t))].path.at(t);
  };
}

PlanProblem plan_problem(const PlanTask& task) {
  PlanCommon common;
  common.task = task;
  common.robot = std::make_shared<const RobotModel>(plant_model(task.scenario));
  if (!task.start.rollout.empty()) common.controller = controller_motion(task, *common.robot);
  common.start = start_state(task, *common.robot, common.controller ? &*common.controller : nullptr);
  check_given_states(common);
  PlanProblem problem;
  switch (task.kind) {
    case PlanKind::kMove:
      problem = move_problem(common);
      break;
    case PlanKind::kTrack:
      problem = track_problem(common);
      break;
    case PlanKind::kSwitch:
      problem = switch_problem(common);
      break;
    case PlanKind::kReturn:
      problem = return_problem(common);
      break;
    case PlanKind::kFastest:
      problem = fastest_problem(common);
      break;
  }
  problem.robot = common.robot;
  if (!problem.gaze_target) problem.gaze_target = active_target(task.scenario);
  const bool has_path_coordinate = task.kind == PlanKind::kFastest;
  if (common.controller && task.kind != PlanKind::kMove && !has_path_coordinate)
    problem.guess = controllers(common.controller->motion, problem.grid);
  if (task.duration && task.kind != PlanKind::kTrack && !task.least_error) {
    PlanTask free = task;
    free.duration.reset();
    problem.free_duration = std::make_shared<PlanProblem>(plan_problem(free));
  }
  return problem;
}

}  // namespace armtune::internal
