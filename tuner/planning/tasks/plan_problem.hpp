#pragma once
// Turns a planning task into an optimisation problem on a time grid, with a first guess of the trajectory.

#include <limits>

#include "tuner/planning/tasks/plan_task.hpp"
#include "tuner/planning/tasks/tool_motion.hpp"
#include "tuner/planning/transcription/refining_solver.hpp"

namespace armtune::internal {

struct PlanProblem {
  std::shared_ptr<const RobotModel> robot;  ///< the scenario's true arm (payload, friction)
  TaskOnGrid task;                          ///< the problem for any number of intervals of the grid
  TimeGrid grid;
  Trajectory guess;         ///< first guess of the motion
  MovingPoint gaze_target;  ///< the target that the gaze (the tool's z axis) points at
  /// Time until which this target is the active one [s]. Reaching it later is of no use.
  double target_until = std::numeric_limits<double>::infinity();
  /// The same problem with a free duration. Null unless the task fixes a duration that could be free.
  std::shared_ptr<const PlanProblem> free_duration;
};

/// Returns the problem of a task. Throws InputError if the arm cannot reach a point of the tool's path that
/// the plan needs, if the start or the goal violates the task's limits, or if a given rollout does not fit
/// the task.
PlanProblem plan_problem(const PlanTask& task);

/// Returns the motion of the gaze target. At each time, this is the scenario's target that is then active.
MovingPoint active_target(const Scenario& scenario);

}  // namespace armtune::internal
